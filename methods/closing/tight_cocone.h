// Tight Cocone (Dey, Goswami 2003): a closed surface through points, from their Delaunay triangulation, as
// Meyer, Kirby and Whitaker (2007, section 3.4) close their particles.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

struct TightCocone {
  std::vector<Triangle> triangles;  ///< counter-clockwise seen from outside, indices into the points
  std::size_t candidates = 0;       ///< cocone facets before pruning
  std::size_t pruned = 0;           ///< of them
  std::size_t undersampled = 0;     ///< points around which the surface does not look flat
  std::size_t bad = 0;              ///< points without exactly one closed umbrella of cocone facets
  std::size_t conflicts = 0;        ///< cells that good points claim for inside and for outside
  std::size_t transparent = 0;      ///< finite cells with bad vertices only
};

/// Cocone facets are reduced to those that a walk along the outer side reaches; where each point has one umbrella of
/// them, cells on either side are marked inside and outside, from the convex hull inwards; then outside eats through
/// the cells that only bad points have, but never through the smallest facet (by circumradius) of such a cell. What
/// bounds the rest is the surface: no edge is open, but edges may have four facets and points two umbrellas, and where
/// sampling fails parts may be missing. Normals come from the poles (as published).
/// `points` in mm, distinct. Throws Error if they span no tetrahedron. One thread; the same points in the same order
/// give the same triangles. Cost: about four times that of the Delaunay triangulation.
TightCocone tight_cocone(const std::vector<Eigen::Vector3d>& points, Monitor& monitor);

/// The same with known unit normals.
TightCocone tight_cocone(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& normals,
                         Monitor& monitor);

}  // namespace isobench
