// The cells of a lattice that F = c may cross, cut into boxes until each box is decided (box_state.h).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/datasets/topology/box_state.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

/// How often a cell is cut at most. A box then is 6e-8 cells wide.
inline constexpr int most_cuts = 24;

/// A box of a tree: a leaf, or eight parts.
struct TreeNode {
  std::uint32_t next = 0;  ///< the first of eight parts; for a leaf with a disc, the disc's number in the layer
  BoxKind kind = BoxKind::without_surface;
  std::uint8_t inside = 0;  ///< see BoxState
  bool is_cut = false;
};

/// The trees of the cells with the same k.
struct CellLayer {
  std::vector<TreeNode> nodes;
  std::vector<std::uint32_t> cells;  ///< i + j · (size[0] − 1) of the cells that F = c crosses, ascending
  std::vector<std::uint32_t> roots;  ///< the node of each of these cells
  std::uint32_t discs = 0;
};

/// Cuts the cells for f + `offset`, at `cut_at` (see usual_cut): one layer for each k from 0 to size[2] − 2.
/// std::nullopt if a box is still undecided after most_cuts cuts. Throws Cancelled. Threads: all.
std::optional<std::vector<CellLayer>> subdivide(const Isosurface& surface, double offset, const Margins& margins,
                                                double cut_at, Monitor& monitor);

/// A part of a lattice cell, in the lattice frame, mm.
struct CellBox {
  Eigen::Vector3d low;
  Eigen::Vector3d high;
};

/// Small boxes, at most one for each cell, that may hold a point with a gradient of zero and a value of f from `low` to
/// `high`. If there is none, it is proven that there is no such point. Throws Cancelled. Threads: all.
std::vector<CellBox> singular_boxes(const Isosurface& surface, double low, double high, double margin, double cut_at,
                                    Monitor& monitor);

}  // namespace isobench
