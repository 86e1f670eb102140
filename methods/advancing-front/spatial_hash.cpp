#include "isobench/methods/advancing-front/spatial_hash.h"

#include <algorithm>
#include <cmath>

namespace isobench::advancing_front {

namespace {

/// The key of a cell; never 0, because 0 marks a free slot.
std::uint64_t key_of(int level, std::int64_t i, std::int64_t j, std::int64_t k) {
  constexpr std::int64_t half = 1 << 18;
  constexpr std::uint64_t mask = (1U << 19) - 1;
  const auto part = [](std::int64_t n) { return static_cast<std::uint64_t>(n + half) & mask; };
  return (static_cast<std::uint64_t>(level) + 1) << 57 | part(i) << 38 | part(j) << 19 | part(k);
}

std::int64_t cell_at(double x, double size) { return static_cast<std::int64_t>(std::floor(x / size)); }

}  // namespace

SpatialHash::SpatialHash(double finest) : finest_(finest), cells_(1024) {}

std::size_t SpatialHash::slot_of(std::uint64_t key) const {
  std::size_t slot = (key * 0x9E3779B97F4A7C15U >> 24) & (cells_.size() - 1);
  while (cells_[slot].key != 0 && cells_[slot].key != key) slot = (slot + 1) & (cells_.size() - 1);
  return slot;
}

std::size_t SpatialHash::slot_for(std::uint64_t key) {
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

void SpatialHash::rehash() {
  // Drop the empty cells here: a front passes most cells only once.
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
    for (int item = cell.first; item >= 0; item = link(item).next) link(item).cell = static_cast<std::int64_t>(slot);
  }
}

void SpatialHash::insert(int item, const Eigen::Vector3d& centre, double radius, double step) {
  const double extent = std::max(4.0 * radius, 2.0 * step);
  int level = 0;
  while (level + 1 < levels && size_of(level) < extent) ++level;
  const double size = size_of(level);
  const std::size_t slot =
      slot_for(key_of(level, cell_at(centre[0], size), cell_at(centre[1], size), cell_at(centre[2], size)));
  if (static_cast<std::size_t>(item) >= links_.size()) links_.resize(static_cast<std::size_t>(item) + 1);
  Cell& cell = cells_[slot];
  link(item) = {-1, cell.first, static_cast<std::int64_t>(slot), level, centre};
  if (cell.first >= 0) link(cell.first).previous = item;
  cell.first = item;
  ++items_in_level_[static_cast<std::size_t>(level)];
}

void SpatialHash::erase(int item) {
  if (static_cast<std::size_t>(item) >= links_.size()) return;
  Link& gone = link(item);
  if (gone.cell < 0) return;
  if (gone.previous >= 0) {
    link(gone.previous).next = gone.next;
  } else {
    cells_[static_cast<std::size_t>(gone.cell)].first = gone.next;
  }
  if (gone.next >= 0) link(gone.next).previous = gone.previous;
  --items_in_level_[static_cast<std::size_t>(gone.level)];
  gone = {};
}

void SpatialHash::near(const Eigen::Vector3d& centre, double radius, double least, std::vector<int>& found) const {
  for (int level = 0; level < levels; ++level) {
    if (items_in_level_[static_cast<std::size_t>(level)] > 0 && size_of(level) >= 2.0 * least) {
      near_in_level(level, centre, radius, found);
    }
  }
}

void SpatialHash::near_in_level(int level, const Eigen::Vector3d& centre, double radius,
                                std::vector<int>& found) const {
  const double size = size_of(level);
  const double reach = radius + 0.25 * size;  // no item is larger than a quarter of its cell
  const Eigen::Vector3d low = centre.array() - reach, high = centre.array() + reach;
  for (std::int64_t k = cell_at(low[2], size); k <= cell_at(high[2], size); ++k) {
    for (std::int64_t j = cell_at(low[1], size); j <= cell_at(high[1], size); ++j) {
      for (std::int64_t i = cell_at(low[0], size); i <= cell_at(high[0], size); ++i) {
        for (int item = cells_[slot_of(key_of(level, i, j, k))].first; item >= 0; item = link(item).next) {
          if ((link(item).centre - centre).squaredNorm() <= reach * reach) found.push_back(item);
        }
      }
    }
  }
}

}  // namespace isobench::advancing_front
