// The facets of a Delaunay triangulation that look like pieces of the surface its points lie on (Amenta, Choi, Dey,
// Leekha 2002), and the points that look as if the surface were flat around them (Dey, Giesen 2001).
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
    std::uint32_t index;                ///< of the facet in the cell
    std::array<std::uint32_t, 3> ends;  ///< its vertices
  };
  std::vector<char> flat;      ///< one a point
  std::vector<Facet> facets;   ///< candidates that were not pruned, in order of their cells
  std::size_t candidates = 0;  ///< before pruning
};

/// The normals that the Voronoi diagram suggests: from each point to its pole, the farthest corner of its Voronoi cell;
/// on the convex hull the mean of the hull facets' normals. Unit; which side they point to means nothing.
std::vector<Eigen::Vector3d> pole_normals(const DelaunayCells& cells, const std::vector<Eigen::Vector3d>& points);

/// A point is flat if its Voronoi cell is at least 1.2 times as high, on either side, as it is wide where the plane
/// normal to its normal cuts it, and the normals of all its cocone neighbours are within π/3 of its own. A facet is a
/// candidate if its dual edge passes the cocone, the directions within π/8 of the tangent plane, of each of its flat
/// vertices; if none is flat, of all three. Then facets are pruned, again and again, at edges between flat points where
/// all facets lie within a wedge of π/3: the surface would turn by more than 2π/3. An edge with one facet stays, and
/// with it the hole that is for others to close: pruning there would unravel all of the surface from one hole.
Cocone cocone(const DelaunayCells& cells, const std::vector<Eigen::Vector3d>& points,
              const std::vector<Eigen::Vector3d>& normals);

}  // namespace isobench
