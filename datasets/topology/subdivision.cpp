#include "isobench/datasets/topology/subdivision.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <array>
#include <atomic>

#include "isobench/datasets/topology/candidate_cells.h"

namespace isobench {

namespace {

/// Cuts one cell after the other. Keeps the polynomials of the boxes on the way down.
class Cutter {
 public:
  Cutter(double cut_at, const Margins& margins) : cut_at_(cut_at), margins_(margins), levels_(most_cuts) {}

  /// Adds the tree of a cell to the layer, unless it turns out that F = c does not cross the cell. Returns false if a
  /// box stays undecided; the layer is then not usable.
  bool add_cell(const Tricubic& cell, std::uint32_t number, CellLayer& layer) {
    const auto root = static_cast<std::uint32_t>(layer.nodes.size());
    layer.nodes.emplace_back();
    if (!expand(root, cell, 0, layer)) return false;
    if (is_empty(layer.nodes[root])) {
      layer.nodes.pop_back();
    } else {
      layer.cells.push_back(number);
      layer.roots.push_back(root);
    }
    return true;
  }

  /// Whether the cell has no point with a gradient of zero and a value from `low` to `high`. If not so, parts() leads
  /// to a box that may have one.
  bool is_regular_cell(const Tricubic& cell, double low, double high) { return is_regular_box(cell, low, high, 0); }

  /// The numbers of the parts that lead to the box, the last one first.
  const std::vector<unsigned>& parts() const { return parts_; }

 private:
  static bool is_empty(const TreeNode& node) { return !node.is_cut && node.kind == BoxKind::without_surface; }

  bool expand(std::uint32_t node, const Tricubic& f, int depth, CellLayer& layer) {
    const BoxState state = examine(f, margins_);
    layer.nodes[node].kind = state.kind;
    layer.nodes[node].inside = state.inside;
    if (state.kind == BoxKind::disc) layer.nodes[node].next = layer.discs++;
    if (state.kind != BoxKind::undecided) return true;
    if (depth == most_cuts) return false;
    const auto first = static_cast<std::uint32_t>(layer.nodes.size());
    layer.nodes.resize(first + 8);
    layer.nodes[node].is_cut = true;
    layer.nodes[node].next = first;
    const std::array<Tricubic, 8>& parts = cut_at_level(f, depth);
    bool empty = true;
    for (std::uint32_t part = 0; part < 8; ++part) {
      if (!expand(first + part, parts[part], depth + 1, layer)) return false;
      empty = empty && is_empty(layer.nodes[first + part]);
    }
    if (empty) {
      layer.nodes.resize(first);
      layer.nodes[node] = {};
    }
    return true;
  }

  bool is_regular_box(const Tricubic& f, double low, double high, int depth) {
    if (is_regular(f, low, high, margins_.difference)) return true;
    if (depth == most_cuts) {
      parts_.clear();
      return false;
    }
    const std::array<Tricubic, 8>& parts = cut_at_level(f, depth);
    for (unsigned part = 0; part < 8; ++part) {
      if (!is_regular_box(parts[part], low, high, depth + 1)) {
        parts_.push_back(part);
        return false;
      }
    }
    return true;
  }

  const std::array<Tricubic, 8>& cut_at_level(const Tricubic& f, int depth) {
    std::array<Tricubic, 8>& parts = levels_[static_cast<std::size_t>(depth)];
    cut(f, cut_at_, parts);
    return parts;
  }

  double cut_at_;
  Margins margins_;
  std::vector<std::array<Tricubic, 8>> levels_;
  std::vector<unsigned> parts_;
};

using Cutters = tbb::enumerable_thread_specific<Cutter>;

/// The box that these parts of cell (i, j, k) lead to, the last one first.
CellBox box_at(const Isosurface& surface, const Eigen::Array3i& cell, const std::vector<unsigned>& parts,
               double cut_at) {
  Eigen::Array3d low(0.0, 0.0, 0.0);
  Eigen::Array3d high(1.0, 1.0, 1.0);
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      const double middle = (1.0 - cut_at) * low[axis] + cut_at * high[axis];
      ((*part >> axis & 1U) != 0 ? low : high)[axis] = middle;
    }
  }
  const Eigen::Array3d spacing = surface.lattice().spacing.array();
  const Eigen::Array3d first = cell.cast<double>();
  return {((first + low) * spacing).matrix(), ((first + high) * spacing).matrix()};
}

}  // namespace

std::optional<std::vector<CellLayer>> subdivide(const Isosurface& surface, double offset, const Margins& margins,
                                                double cut_at, Monitor& monitor) {
  const int layers = surface.lattice().size[2] - 1;
  const int columns = surface.lattice().size[0] - 1;
  std::vector<CellLayer> all(static_cast<std::size_t>(layers));
  Cutters cutters([cut_at, margins] { return Cutter(cut_at, margins); });
  std::atomic<bool> is_decided = true;
  tbb::parallel_for(0, layers, [&](int k) {
    Cutter& cutter = cutters.local();
    for (const auto& [i, j] : candidate_cells(surface, k, -offset - margins.value, -offset + margins.value)) {
      if (!is_decided || monitor.is_cancelled()) return;
      const auto number = static_cast<std::uint32_t>(i + j * columns);
      if (!cutter.add_cell(cell_polynomial(surface, i, j, k, offset), number, all[static_cast<std::size_t>(k)]))
        is_decided = false;
    }
  });
  monitor.check();
  if (!is_decided) return std::nullopt;
  return all;
}

std::vector<CellBox> singular_boxes(const Isosurface& surface, double low, double high, double margin, double cut_at,
                                    Monitor& monitor) {
  const int layers = surface.lattice().size[2] - 1;
  std::vector<std::vector<CellBox>> found(static_cast<std::size_t>(layers));
  Cutters cutters([cut_at, margin] { return Cutter(cut_at, Margins{margin, margin}); });
  tbb::parallel_for(0, layers, [&](int k) {
    Cutter& cutter = cutters.local();
    for (const auto& [i, j] : candidate_cells(surface, k, low, high)) {
      if (monitor.is_cancelled()) return;
      if (!cutter.is_regular_cell(cell_polynomial(surface, i, j, k, 0.0), low, high))
        found[static_cast<std::size_t>(k)].push_back(box_at(surface, {i, j, k}, cutter.parts(), cut_at));
    }
  });
  monitor.check();
  std::vector<CellBox> all;
  for (const std::vector<CellBox>& of_layer : found) all.insert(all.end(), of_layer.begin(), of_layer.end());
  return all;
}

}  // namespace isobench
