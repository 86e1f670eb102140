// The cells of a lattice that F = c may cross, cut into boxes until each box is decided (box_state.h).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/datasets/topology/box_state.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

struct CutRule {
  double at = usual_cut;  ///< see usual_cut
  int deepest = 24;       ///< how often a cell is cut at most; a box then is 6e-8 cells wide
};

/// A part of a lattice cell, from its path of cuts.
struct Box {
  Eigen::Vector3d low;   ///< lattice frame, mm
  Eigen::Vector3d high;  ///< lattice frame, mm
  int depth = 0;         ///< number of cuts
};

/// A box of a tree: a leaf, or eight parts.
struct TreeNode {
  std::uint32_t next = 0;  ///< the first of eight parts; for a leaf with a disc, its number in the slab
  BoxKind kind = BoxKind::without_surface;
  std::uint8_t inside = 0;
  bool is_cut = false;
};

/// The trees of the cells with the same k.
struct CellSlab {
  std::vector<TreeNode> nodes;
  std::vector<std::uint32_t> cells;  ///< i + j · (size[0] − 1) of the cells that F = c crosses, ascending
  std::vector<std::uint32_t> roots;  ///< the node of each
  std::uint32_t discs = 0;
  std::vector<Box> undecided;  ///< at most one per cell
};

/// Cuts all cells. One slab for each k from 0 to size[2] − 2. With `stop_early`, the first undecided box ends the work,
/// and the slabs are not complete. Cost: 5 µs of one thread for each cell that F = c may cross.
std::vector<CellSlab> subdivide(const Isosurface& surface, double offset, double margin, const CutRule& rule,
                                bool stop_early, Monitor& monitor);

/// Boxes that may hold a point with a gradient of zero and a value of f from `low` to `high`, at most one per cell;
/// none if it is proven that there is no such point.
std::vector<Box> singular_boxes(const Isosurface& surface, double low, double high, double margin, const CutRule& rule,
                                Monitor& monitor);

}  // namespace isobench
