// Seeds: the points on the surface from which the relaxation starts.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/methods/particles/sampling/sized_surface.h"

namespace isobench::particles {

/// The number of particles in a hexagonal packing with the spacing of `sized` on the mesh: Σ area · 2/(√3 spacing²).
double ideal_count(const SizedSurface& sized, const TriangleMesh& mesh);

/// About `count` points on F = c by weighted sample elimination (Yuksel 2015): draws `per_seed` · `count` random points
/// on the mesh with density 1/spacing², projects them, and removes the most crowded point until `count` are left.
/// `mesh` approximates F = c. The points are in Morton order; no two coincide. The same seed gives the same points for
/// any number of threads.
std::vector<Eigen::Vector3d> eliminate_to_seeds(const SizedSurface& sized, const TriangleMesh& mesh, std::size_t count,
                                                double per_seed, std::uint64_t seed, Monitor& monitor);

/// The seeds of the published method: every fourth vertex of the mesh, projected to F = c. If seeds coincide, only
/// the first is kept.
std::vector<Eigen::Vector3d> lattice_seeds(const Isosurface& surface, const TriangleMesh& mesh);

}  // namespace isobench::particles
