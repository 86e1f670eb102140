#include "isobench/methods/particles/sampling/neighbours.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <span>

namespace isobench::particles {

namespace {

using Cell = std::array<std::int32_t, 3>;

std::uint64_t mix(std::uint64_t h) {
  h ^= h >> 31;
  h *= 0x9E3779B97F4A7C15U;
  return h ^ (h >> 29);
}

/// Particles sorted by grid and cell, and a hash table from a cell to its particles. Level n is the grid whose cells
/// are 2ⁿ times as wide as the cells of the finest grid.
class Grids {
 public:
  struct Occupied {
    std::uint64_t key = 0;
    std::uint32_t first = 0;  // in order()
    std::uint32_t count = 0;
    int level = 0;
  };

  Grids(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& reach)
      : finest_(*std::min_element(reach.begin(), reach.end())) {
    for (const Eigen::Vector3d& x : points) low_ = low_.cwiseMin(x);
    std::vector<Entry> entries(points.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 4096), [&](const auto& range) {
      for (std::size_t n = range.begin(); n < range.end(); ++n) {
        const int level = level_of(reach[n]);
        entries[n] = {key(level, cell_of(points[n], level)), static_cast<std::uint32_t>(n)};
      }
    });
    tbb::parallel_sort(entries.begin(), entries.end());
    fill_cells(entries);
    fill_table();
    find_finer_cells();
  }

  int level_count() const { return level_count_; }
  /// The occupied cells of finer grids in which particles of a cell can have neighbours.
  std::span<const std::uint32_t> finer_than(std::size_t cell) const {
    return {finer_.data() + finer_first_[cell], finer_first_[cell + 1] - finer_first_[cell]};
  }
  double cell_width(int level) const { return std::ldexp(finest_, level + 1); }
  const std::vector<std::uint32_t>& order() const { return order_; }
  const std::vector<Occupied>& cells() const { return cells_; }

  /// Calls visit(cell) for every occupied cell of a grid that meets the box.
  template <typename Visit>
  void visit_box(int level, const Eigen::Vector3d& low, const Eigen::Vector3d& high, Visit visit) const {
    const Cell first = cell_of(low, level);
    const Cell last = cell_of(high, level);
    for (std::int32_t k = first[2]; k <= last[2]; ++k) {
      for (std::int32_t j = first[1]; j <= last[1]; ++j) {
        for (std::int32_t i = first[0]; i <= last[0]; ++i) {
          const std::uint32_t found = find(key(level, {i, j, k}));
          if (found != none) visit(cells_[found]);
        }
      }
    }
  }

 private:
  struct Entry {
    std::uint64_t key;
    std::uint32_t particle;
    bool operator<(const Entry& other) const { return key != other.key ? key < other.key : particle < other.particle; }
  };
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  int level_of(double reach) const { return std::max(0, static_cast<int>(std::floor(std::log2(reach / finest_)))); }

  Cell cell_of(const Eigen::Vector3d& x, int level) const {
    const double width = cell_width(level);
    Cell cell{};
    for (int axis = 0; axis < 3; ++axis) {
      cell[static_cast<std::size_t>(axis)] = static_cast<std::int32_t>(std::floor((x[axis] - low_[axis]) / width));
    }
    return cell;
  }

  /// 7 bits for the level and 19 for each index. Indices start at −1, because a box may begin one cell before the
  /// first.
  static std::uint64_t key(int level, const Cell& cell) {
    auto result = static_cast<std::uint64_t>(level);
    for (const std::int32_t index : cell) result = result << 19 | (static_cast<std::uint64_t>(index + 1) & 0x7FFFF);
    return result;
  }

  void fill_cells(const std::vector<Entry>& entries) {
    order_.resize(entries.size());
    for (std::uint32_t n = 0; n < entries.size(); ++n) {
      order_[n] = entries[n].particle;
      if (n == 0 || entries[n].key != entries[n - 1].key) {
        cells_.push_back({entries[n].key, n, 0, static_cast<int>(entries[n].key >> 57)});
      }
      ++cells_.back().count;
    }
    level_count_ = cells_.back().level + 1;
  }

  void fill_table() {
    table_.assign(std::bit_ceil(2 * cells_.size() + 1), none);
    for (std::uint32_t n = 0; n < cells_.size(); ++n) {
      std::size_t at = mix(cells_[n].key) & (table_.size() - 1);
      while (table_[at] != none) at = (at + 1) & (table_.size() - 1);
      table_[at] = n;
    }
  }

  /// The reach of a particle is at most the width of the cells of its grid. So only few coarse cells are looked up for
  /// each fine cell. The other way round, many fine cells would be looked up for each coarse cell, nearly all of them
  /// empty.
  void find_finer_cells() {
    struct Pair {
      std::uint32_t coarse;
      std::uint32_t fine;
    };
    constexpr std::size_t chunk = 1024;
    std::vector<std::vector<Pair>> pairs((cells_.size() + chunk - 1) / chunk);
    tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t c) {
      for (std::size_t n = c * chunk; n < std::min(cells_.size(), (c + 1) * chunk); ++n) {
        const double width = cell_width(cells_[n].level);
        const Eigen::Vector3d low = low_ + width * index_of(cells_[n].key).cast<double>();
        const Eigen::Vector3d margin = Eigen::Vector3d::Constant(width);
        for (int level = cells_[n].level + 1; level < level_count_; ++level) {
          visit_box(level, low - margin, low + 2.0 * margin, [&](const Occupied& coarse) {
            pairs[c].push_back({static_cast<std::uint32_t>(&coarse - cells_.data()), static_cast<std::uint32_t>(n)});
          });
        }
      }
    });
    finer_first_.assign(cells_.size() + 1, 0);
    for (const auto& some : pairs) {
      for (const Pair& pair : some) ++finer_first_[pair.coarse + 1];
    }
    std::partial_sum(finer_first_.begin(), finer_first_.end(), finer_first_.begin());
    finer_.resize(finer_first_.back());
    std::vector<std::uint32_t> next(finer_first_.begin(), finer_first_.end() - 1);
    for (const auto& some : pairs) {
      for (const Pair& pair : some) finer_[next[pair.coarse]++] = pair.fine;
    }
  }

  static Eigen::Vector3i index_of(std::uint64_t key) {
    const auto part = [key](int shift) { return static_cast<int>(key >> shift & 0x7FFFF) - 1; };
    return {part(38), part(19), part(0)};
  }

  std::uint32_t find(std::uint64_t wanted) const {
    std::size_t at = mix(wanted) & (table_.size() - 1);
    while (table_[at] != none && cells_[table_[at]].key != wanted) at = (at + 1) & (table_.size() - 1);
    return table_[at];
  }

  double finest_;
  Eigen::Vector3d low_ = Eigen::Vector3d::Constant(1e300);
  int level_count_ = 0;
  std::vector<std::uint32_t> order_;
  std::vector<Occupied> cells_;
  std::vector<std::uint32_t> table_;
  std::vector<std::uint32_t> finer_first_;
  std::vector<std::uint32_t> finer_;
};

/// Particles that may be neighbours of the particles in a cell. Coordinates are in separate arrays so that the distance
/// loop vectorises.
struct Candidates {
  std::vector<std::uint32_t> index;
  std::vector<double> x, y, z, squared_reach;

  void clear() {
    index.clear();
    for (auto* values : {&x, &y, &z, &squared_reach}) values->clear();
  }
  void add(std::uint32_t n, const Eigen::Vector3d& point, double reach) {
    index.push_back(n);
    x.push_back(point[0]);
    y.push_back(point[1]);
    z.push_back(point[2]);
    squared_reach.push_back(reach * reach);
  }
};

/// Collects the candidates for all particles of a cell.
void gather(const Grids& grids, const Grids::Occupied& cell, const std::vector<Eigen::Vector3d>& points,
            const std::vector<double>& reach, Candidates& candidates) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300);
  Eigen::Vector3d high = -low;
  double farthest = 0.0;
  for (std::uint32_t n = cell.first; n < cell.first + cell.count; ++n) {
    const std::uint32_t i = grids.order()[n];
    low = low.cwiseMin(points[i]);
    high = high.cwiseMax(points[i]);
    farthest = std::max(farthest, reach[i]);
  }
  candidates.clear();
  const auto add_all = [&](const Grids::Occupied& other) {
    for (std::uint32_t n = other.first; n < other.first + other.count; ++n) {
      const std::uint32_t j = grids.order()[n];
      candidates.add(j, points[j], reach[j]);
    }
  };
  for (const std::uint32_t fine : grids.finer_than(static_cast<std::size_t>(&cell - grids.cells().data())))
    add_all(grids.cells()[fine]);
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(farthest);
  for (int level = cell.level; level < grids.level_count(); ++level)
    grids.visit_box(level, low - margin, high + margin, add_all);
}

void append_neighbours(std::uint32_t i, const Eigen::Vector3d& point, double reach, const Candidates& candidates,
                       std::vector<std::uint32_t>& items) {
  const double own = reach * reach;
  for (std::size_t n = 0; n < candidates.index.size(); ++n) {
    const double dx = candidates.x[n] - point[0];
    const double dy = candidates.y[n] - point[1];
    const double dz = candidates.z[n] - point[2];
    const double square = dx * dx + dy * dy + dz * dz;
    if (square < own && square < candidates.squared_reach[n] && candidates.index[n] != i)
      items.push_back(candidates.index[n]);
  }
}

}  // namespace

NeighbourLists find_neighbours(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& reach) {
  NeighbourLists lists;
  lists.first.assign(points.size(), 0);
  lists.count.assign(points.size(), 0);
  if (points.empty()) return lists;
  const Grids grids(points, reach);
  constexpr std::size_t chunk = 256;  // cells
  const std::size_t chunks = (grids.cells().size() + chunk - 1) / chunk;
  std::vector<std::vector<std::uint32_t>> found(chunks);
  tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t c) {
    std::vector<std::uint32_t>& items = found[c];
    Candidates candidates;
    for (std::size_t at = c * chunk; at < std::min(grids.cells().size(), (c + 1) * chunk); ++at) {
      const Grids::Occupied& cell = grids.cells()[at];
      gather(grids, cell, points, reach, candidates);
      for (std::uint32_t n = cell.first; n < cell.first + cell.count; ++n) {
        const std::uint32_t i = grids.order()[n];
        lists.first[i] = items.size();
        append_neighbours(i, points[i], reach[i], candidates, items);
        lists.count[i] = static_cast<std::uint32_t>(items.size() - lists.first[i]);
      }
    }
  });
  std::vector<std::size_t> start(chunks + 1, 0);
  for (std::size_t c = 0; c < chunks; ++c) start[c + 1] = start[c] + found[c].size();
  lists.items.resize(start.back());
  tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t c) {
    std::copy(found[c].begin(), found[c].end(), lists.items.begin() + static_cast<std::ptrdiff_t>(start[c]));
    found[c] = {};
    const std::size_t last = std::min(grids.cells().size(), (c + 1) * chunk) - 1;
    const std::uint32_t end = grids.cells()[last].first + grids.cells()[last].count;
    for (std::uint32_t n = grids.cells()[c * chunk].first; n < end; ++n) lists.first[grids.order()[n]] += start[c];
  });
  return lists;
}

}  // namespace isobench::particles
