// Where Delaunay refinement starts.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench::delaunay_refinement {

/// Vertices of a mesh whose vertices are on F = c: of each component some that are farther from one another than
/// `spacing` mm, each as far as possible from those before it, at least 8 and at most 200 (as far as there are).
/// Refinement finds a component only from points on it, and a few enclose a small body. Sheets that the mesh joins are
/// met alike. Time: vertices × seeds.
std::vector<Eigen::Vector3d> seeds_on(const TriangleMesh& mesh, double spacing, std::uint64_t seed);

}  // namespace isobench::delaunay_refinement
