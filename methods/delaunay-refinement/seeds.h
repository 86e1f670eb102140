// The points from which Delaunay refinement starts.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench::delaunay_refinement {

/// Chooses vertices of a mesh whose vertices lie on F = c. In each component, vertices are chosen by farthest-point
/// sampling while the next one is farther than `spacing` mm from those chosen, but at least 8 (if there are so many)
/// and at most 200. Refinement finds a component only if seeds lie on it, and needs a few to enclose a small body.
/// Where the mesh joins two components of F = c, the distances make seeds on both likely. Time: O(vertices × seeds).
std::vector<Eigen::Vector3d> seeds_on(const TriangleMesh& mesh, double spacing, std::uint64_t seed);

}  // namespace isobench::delaunay_refinement
