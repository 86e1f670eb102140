// Tight Cocone (Dey, Goswami 2003): a closed surface through points, made of facets of their Delaunay triangulation.
// Meyer, Kirby and Whitaker (2007, section 3.4) close their particles with it.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

struct TightCocone {
  std::vector<Triangle> triangles;  ///< indices of points, counter-clockwise seen from outside
  std::size_t candidates = 0;       ///< cocone facets before pruning
  std::size_t pruned = 0;           ///< cocone facets that pruning removed
  std::size_t undersampled = 0;     ///< points that are not flat (cocone.h)
  std::size_t bad = 0;              ///< points whose cocone facets do not form exactly one closed umbrella
  std::size_t conflicts = 0;        ///< cells that good points mark both inside and outside
  std::size_t transparent = 0;      ///< finite cells all of whose vertices are bad
};

/// 1. Only the cocone facets that a walk along the outer side reaches are kept (outer_walk.h). A point is good if these
///    facets form one closed umbrella around it.
/// 2. From the convex hull inwards, the umbrella of each good point separates its cells into inside and outside.
/// 3. The outside is extended through cells whose vertices are all bad, but not through that facet of such a cell which
///    has the smallest circumradius.
/// 4. The boundary of the cells that are not outside is the surface.
///
/// No edge is open, but an edge may have four facets and a point two umbrellas, and parts may be missing where the
/// sampling is too sparse. Normals come from the poles, as published. `points` are distinct, mm. Throws Error if they
/// span no tetrahedron. One thread; the same points in the same order give the same triangles. Cost: about four
/// times as much as the Delaunay triangulation.
TightCocone tight_cocone(const std::vector<Eigen::Vector3d>& points, Monitor& monitor);

/// The same with given unit normals.
TightCocone tight_cocone(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& normals,
                         Monitor& monitor);

}  // namespace isobench
