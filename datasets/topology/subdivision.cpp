#include "isobench/datasets/topology/subdivision.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>

namespace isobench {

namespace {

using Parts = std::array<Tricubic, 8>;

/// The smallest and largest of four neighbours, taken along one axis after the other.
struct Window {
  std::vector<float> least;
  std::vector<float> most;

  /// Replaces each value by the bounds of those at distance −1 to 2 along a line; what is beyond the ends is left out.
  void widen(std::size_t first, std::size_t count, std::size_t step) {
    slide(least, first, count, step, [](float a, float b) { return a < b ? a : b; });
    slide(most, first, count, step, [](float a, float b) { return a > b ? a : b; });
  }

 private:
  template <class Choose>
  static void slide(std::vector<float>& values, std::size_t first, std::size_t count, std::size_t step, Choose choose) {
    float before = values[first];
    for (std::size_t n = 0; n < count; ++n) {
      float& here = values[first + n * step];
      float chosen = choose(before, here);
      before = here;
      if (n + 1 < count) chosen = choose(chosen, values[first + (n + 1) * step]);
      if (n + 2 < count) chosen = choose(chosen, values[first + (n + 2) * step]);
      here = chosen;
    }
  }
};

/// Bounds of the coefficients that F in the cells of slab k is made of: those of cell (i, j) are at i + j · size[0].
Window coefficient_bounds(const Isosurface& surface, int k) {
  const auto columns = static_cast<std::size_t>(surface.lattice().size[0]);
  const auto rows = static_cast<std::size_t>(surface.lattice().size[1]);
  Window window;
  window.least.resize(columns * rows);
  window.most.resize(columns * rows);
  for (std::size_t n = 0; n < columns * rows; ++n) {
    const int i = static_cast<int>(n % columns);
    const int j = static_cast<int>(n / columns);
    const std::array<float, 4> c = {surface.coefficient(i, j, k - 1), surface.coefficient(i, j, k),
                                    surface.coefficient(i, j, k + 1), surface.coefficient(i, j, k + 2)};
    window.least[n] = std::min(std::min(c[0], c[1]), std::min(c[2], c[3]));
    window.most[n] = std::max(std::max(c[0], c[1]), std::max(c[2], c[3]));
  }
  for (std::size_t j = 0; j < rows; ++j) window.widen(j * columns, columns, 1);
  for (std::size_t i = 0; i < columns; ++i) window.widen(i, rows, columns);
  return window;
}

/// Calls `visit(i, j)` for the cells of slab k whose coefficients allow values of f from `low` to `high`.
template <class Visit>
void for_candidates(const Isosurface& surface, int k, double low, double high, Visit&& visit) {
  const Window window = coefficient_bounds(surface, k);
  // Catmull-Rom leaves the range of its samples, along each axis by at most an eighth of it on either side: the weights
  // of the outer two samples are at least −1/16 each, and at the middle they are both.
  const double overshoot = surface.kernel() == Kernel::catmull_rom ? 0.5 : 0.0;
  for (int j = 0; j + 1 < surface.lattice().size[1]; ++j) {
    for (int i = 0; i + 1 < surface.lattice().size[0]; ++i) {
      const std::size_t n = static_cast<std::size_t>(j) * static_cast<std::size_t>(surface.lattice().size[0]) +
                            static_cast<std::size_t>(i);
      const double beyond = overshoot * (static_cast<double>(window.most[n]) - static_cast<double>(window.least[n]));
      if (window.least[n] - beyond <= high && window.most[n] + beyond >= low) visit(i, j);
    }
  }
}

/// Cuts cells and remembers the polynomials of the boxes on the way down.
class Cutter {
 public:
  explicit Cutter(const CutRule& rule) : rule_(rule), levels_(static_cast<std::size_t>(rule.deepest)) {}

  /// Adds the tree of a cell to the slab; returns false if a box stays undecided. A cell that turns out to be without
  /// surface leaves the slab as it was.
  bool add_cell(const Tricubic& cell, double margin, std::uint32_t number, CellSlab& slab) {
    margin_ = margin;
    const auto root = static_cast<std::uint32_t>(slab.nodes.size());
    slab.nodes.emplace_back();
    if (!expand(root, cell, 0, slab)) return false;
    if (!slab.nodes[root].is_cut && slab.nodes[root].kind == BoxKind::without_surface) {
      slab.nodes.pop_back();
    } else {
      slab.cells.push_back(number);
      slab.roots.push_back(root);
    }
    return true;
  }

  /// Whether no box of the cell may have a value between `low` and `high` at a gradient of zero.
  bool is_regular_cell(const Tricubic& cell, double low, double high, double margin) {
    return is_regular_box(cell, low, high, margin, 0);
  }

  /// The path of the box at which the last call returned false.
  const std::vector<int>& path() const { return path_; }

 private:
  bool expand(std::uint32_t node, const Tricubic& f, int depth, CellSlab& slab) {
    const BoxState state = examine(f, margin_);
    slab.nodes[node].kind = state.kind;
    slab.nodes[node].inside = state.inside;
    if (state.kind == BoxKind::disc) slab.nodes[node].next = slab.discs++;
    if (state.kind != BoxKind::undecided) return true;
    if (depth == rule_.deepest) {
      path_.clear();
      return false;
    }
    const auto first = static_cast<std::uint32_t>(slab.nodes.size());
    slab.nodes.resize(first + 8);
    slab.nodes[node].is_cut = true;
    slab.nodes[node].next = first;
    Parts& parts = levels_[static_cast<std::size_t>(depth)];
    cut(f, rule_.at, parts);
    bool empty = true;
    for (std::uint32_t part = 0; part < 8; ++part) {
      if (!expand(first + part, parts[part], depth + 1, slab)) {
        path_.insert(path_.begin(), static_cast<int>(part));
        return false;
      }
      const TreeNode& made = slab.nodes[first + part];
      empty = empty && !made.is_cut && made.kind == BoxKind::without_surface;
    }
    if (empty) {
      slab.nodes.resize(first);
      slab.nodes[node] = {};
    }
    return true;
  }

  bool is_regular_box(const Tricubic& f, double low, double high, double margin, int depth) {
    if (is_regular(f, low, high, margin)) return true;
    if (depth == rule_.deepest) {
      path_.clear();
      return false;
    }
    Parts& parts = levels_[static_cast<std::size_t>(depth)];
    cut(f, rule_.at, parts);
    for (int part = 0; part < 8; ++part) {
      if (!is_regular_box(parts[static_cast<std::size_t>(part)], low, high, margin, depth + 1)) {
        path_.insert(path_.begin(), part);
        return false;
      }
    }
    return true;
  }

  CutRule rule_;
  std::vector<Parts> levels_;
  std::vector<int> path_;
  double margin_ = 0.0;
};

/// The box at the end of a path in cell (i, j, k).
Box box_at(const Isosurface& surface, int i, int j, int k, const std::vector<int>& path, double at) {
  Eigen::Array3d low(0.0, 0.0, 0.0);
  Eigen::Array3d high(1.0, 1.0, 1.0);
  for (const int part : path) {
    for (int axis = 0; axis < 3; ++axis) {
      const double middle = (1.0 - at) * low[axis] + at * high[axis];
      ((part >> axis & 1) != 0 ? low : high)[axis] = middle;
    }
  }
  const Eigen::Array3d first(i, j, k);
  const Eigen::Array3d spacing = surface.lattice().spacing.array();
  return {((first + low) * spacing).matrix(), ((first + high) * spacing).matrix(), static_cast<int>(path.size())};
}

}  // namespace

std::vector<CellSlab> subdivide(const Isosurface& surface, double offset, double margin, const CutRule& rule,
                                bool stop_early, Monitor& monitor) {
  const int slabs = surface.lattice().size[2] - 1;
  const int columns = surface.lattice().size[0] - 1;
  std::vector<CellSlab> all(static_cast<std::size_t>(slabs));
  tbb::enumerable_thread_specific<Cutter> cutters([&rule] { return Cutter(rule); });
  std::atomic<bool> stop = false;
  tbb::parallel_for(0, slabs, [&](int k) {
    if (stop || monitor.is_cancelled()) return;
    CellSlab& slab = all[static_cast<std::size_t>(k)];
    Cutter& cutter = cutters.local();
    for_candidates(surface, k, -offset - margin, -offset + margin, [&](int i, int j) {
      if (stop) return;
      const auto number = static_cast<std::uint32_t>(i + j * columns);
      if (cutter.add_cell(cell_polynomial(surface, i, j, k, offset), margin, number, slab)) return;
      slab.undecided.push_back(box_at(surface, i, j, k, cutter.path(), rule.at));
      if (stop_early) stop = true;
    });
  });
  monitor.check();
  return all;
}

std::vector<Box> singular_boxes(const Isosurface& surface, double low, double high, double margin, const CutRule& rule,
                                Monitor& monitor) {
  const int slabs = surface.lattice().size[2] - 1;
  std::vector<std::vector<Box>> found(static_cast<std::size_t>(slabs));
  tbb::enumerable_thread_specific<Cutter> cutters([&rule] { return Cutter(rule); });
  tbb::parallel_for(0, slabs, [&](int k) {
    if (monitor.is_cancelled()) return;
    Cutter& cutter = cutters.local();
    for_candidates(surface, k, low - margin, high + margin, [&](int i, int j) {
      if (!cutter.is_regular_cell(cell_polynomial(surface, i, j, k, 0.0), low, high, margin))
        found[static_cast<std::size_t>(k)].push_back(box_at(surface, i, j, k, cutter.path(), rule.at));
    });
  });
  monitor.check();
  std::vector<Box> all;
  for (const std::vector<Box>& of_slab : found) all.insert(all.end(), of_slab.begin(), of_slab.end());
  return all;
}

}  // namespace isobench
