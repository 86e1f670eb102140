// Seeds near critical points of F (methods/sizing/critical_points/critical_points.h), where features are smaller than
// the sizing's floor or than a voxel. The topology of F = c depends on these features, so particles must be dense
// there.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "isobench/methods/particles/sampling/sized_surface.h"
#include "isobench/methods/sizing/critical_points/critical_points.h"

namespace isobench::particles {

/// One bound for each point, in the same order: h = 2ε · the point's distance from the surface, but at least `floor`
/// mm (equation 1 of Meyer, Kirby, Whitaker 2007; near a critical point, λ and 1/κ are about that distance). The bounds
/// have no plateau; their scale is one voxel.
std::vector<SizeBound> critical_bounds(const std::vector<CriticalPoint>& points, double epsilon, double floor,
                                       double voxel);

/// Adds seeds on F = c around the points until no candidate has room. A new seed keeps 0.75 times the spacing from all
/// other seeds; a seed on a sheet that faces the other way does not count. Precondition: the first bounds of `sized`
/// belong to the points (critical_bounds). `seed` determines the random candidates. The result does not depend on
/// the number of threads.
void add_critical_seeds(const std::vector<CriticalPoint>& points, const SizedSurface& sized, std::uint64_t seed,
                        std::vector<Eigen::Vector3d>& seeds);

}  // namespace isobench::particles
