#include "methods/advancing-front/edge_grid.h"

#include <algorithm>
#include <cmath>

namespace isobench::advancing_front {

namespace {

/// Never 0, which marks a free cell.
std::uint64_t key_of(int level, std::int64_t i, std::int64_t j, std::int64_t k) {
  constexpr std::int64_t half = 1 << 18;
  constexpr std::uint64_t mask = (1U << 19) - 1;
  const auto part = [](std::int64_t n) { return static_cast<std::uint64_t>(n + half) & mask; };
  return (static_cast<std::uint64_t>(level) + 1) << 57 | part(i) << 38 | part(j) << 19 | part(k);
}

std::int64_t cell_at(double x, double size) { return static_cast<std::int64_t>(std::floor(x / size)); }

}  // namespace

EdgeGrid::EdgeGrid(double finest) : finest_(finest), cells_(1024) {}

std::size_t EdgeGrid::slot_of(std::uint64_t key) const {
  std::size_t slot = (key * 0x9E3779B97F4A7C15U >> 24) & (cells_.size() - 1);
  while (cells_[slot].key != 0 && cells_[slot].key != key) slot = (slot + 1) & (cells_.size() - 1);
  return slot;
}

std::size_t EdgeGrid::slot_for(std::uint64_t key) {
  std::size_t slot = slot_of(key);
  if (cells_[slot].key == 0) {
    if (2 * ++used_ > cells_.size()) {
      rehash();
      slot = slot_of(key);
    }
    cells_[slot].key = key;
  }
  return slot;
}

void EdgeGrid::rehash() {
  // Cells that have emptied are dropped here; a front passes over most of them only once.
  std::vector<Cell> old(cells_.size());
  old.swap(cells_);
  const auto full =
      static_cast<std::size_t>(std::count_if(old.begin(), old.end(), [](const Cell& cell) { return cell.first >= 0; }));
  while (cells_.size() < 8 * full) cells_.resize(2 * cells_.size());
  used_ = 1;
  for (const Cell& cell : old) {
    if (cell.first < 0) continue;
    const std::size_t slot = slot_of(cell.key);
    cells_[slot] = cell;
    ++used_;
    for (int edge = cell.first; edge >= 0; edge = links_[static_cast<std::size_t>(edge)].next) {
      links_[static_cast<std::size_t>(edge)].cell = static_cast<std::int64_t>(slot);
    }
  }
}

void EdgeGrid::insert(int edge, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const double length = (to - from).norm();
  int level = 0;
  while (level + 1 < levels && size_of(level) < length) ++level;
  const Eigen::Vector3d middle = 0.5 * (from + to);
  const double size = size_of(level);
  const std::size_t slot =
      slot_for(key_of(level, cell_at(middle[0], size), cell_at(middle[1], size), cell_at(middle[2], size)));
  if (static_cast<std::size_t>(edge) >= links_.size()) links_.resize(static_cast<std::size_t>(edge) + 1);
  Cell& cell = cells_[slot];
  links_[static_cast<std::size_t>(edge)] = {-1, cell.first, static_cast<std::int64_t>(slot), level};
  if (cell.first >= 0) links_[static_cast<std::size_t>(cell.first)].previous = edge;
  cell.first = edge;
  ++edges_in_level_[static_cast<std::size_t>(level)];
}

void EdgeGrid::erase(int edge) {
  if (static_cast<std::size_t>(edge) >= links_.size()) return;
  Link& link = links_[static_cast<std::size_t>(edge)];
  if (link.cell < 0) return;
  if (link.previous >= 0) {
    links_[static_cast<std::size_t>(link.previous)].next = link.next;
  } else {
    cells_[static_cast<std::size_t>(link.cell)].first = link.next;
  }
  if (link.next >= 0) links_[static_cast<std::size_t>(link.next)].previous = link.previous;
  --edges_in_level_[static_cast<std::size_t>(link.level)];
  link = {};
}

void EdgeGrid::near(const Eigen::Vector3d& centre, double radius, double least, std::vector<int>& found) const {
  for (int level = 0; level < levels; ++level) {
    const double size = size_of(level);
    if (edges_in_level_[static_cast<std::size_t>(level)] == 0 || size < least) continue;
    // An edge is no longer than its cell is wide, so its midpoint is within half of that.
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(radius + 0.5 * size);
    const Eigen::Vector3d low = centre - reach, high = centre + reach;
    for (std::int64_t k = cell_at(low[2], size); k <= cell_at(high[2], size); ++k) {
      for (std::int64_t j = cell_at(low[1], size); j <= cell_at(high[1], size); ++j) {
        for (std::int64_t i = cell_at(low[0], size); i <= cell_at(high[0], size); ++i) {
          const Cell& cell = cells_[slot_of(key_of(level, i, j, k))];
          for (int edge = cell.first; edge >= 0; edge = links_[static_cast<std::size_t>(edge)].next) {
            found.push_back(edge);
          }
        }
      }
    }
  }
}

}  // namespace isobench::advancing_front
