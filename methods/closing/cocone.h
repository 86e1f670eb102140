// Cocone: the facets of a Delaunay triangulation that are likely to be part of the surface through its points (Amenta,
// Choi, Dey, Leekha 2002), and the points around which the surface is likely to be flat (Dey, Giesen 2001).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "isobench/methods/closing/delaunay_cells.h"

namespace isobench {

struct Cocone {
  struct Facet {
    std::uint32_t cell;
    std::uint32_t index;                ///< index of the facet in the cell
    std::array<std::uint32_t, 3> ends;  ///< its vertices
  };
  std::vector<char> flat;      ///< for each point, whether the surface is flat there
  std::vector<Facet> facets;   ///< candidates that remain after pruning, in the order of their cells
  std::size_t candidates = 0;  ///< number of candidates before pruning
};

/// Normals from the Voronoi diagram: the direction from a point to its pole, the farthest corner of its Voronoi cell;
/// on the convex hull, the mean of the hull facets' normals. Unit vectors with an arbitrary sign.
std::vector<Eigen::Vector3d> pole_normals(const DelaunayCells& cells, const std::vector<Eigen::Vector3d>& points);

/// The cocone of a point is the set of directions within π/8 of its tangent plane. A point is flat if two things hold:
/// its Voronoi cell is at least 1.2 times as high on either side as it is wide in the tangent plane, and the normals of
/// all its cocone neighbours are within π/3 of its own.
///
/// A facet is a candidate if its dual edge passes the cocone of each of its flat vertices; if none is flat, of all
/// three. Candidates are pruned at edges between flat points where all facets are within a wedge of π/3, because the
/// surface would turn by more than 2π/3 there. Pruning repeats until there is no such edge. It leaves edges with a
/// single facet alone: pruning at the rim of a hole would remove the whole surface. Holes are closed later
/// (tight_cocone.h).
Cocone cocone(const DelaunayCells& cells, const std::vector<Eigen::Vector3d>& points,
              const std::vector<Eigen::Vector3d>& normals);

}  // namespace isobench
