// Where the sizing's floor, or its lattice of nodes, is too coarse for the topology of F = c: near critical points of F
// (methods/sizing/critical_points/critical_points.h). Particles are packed there as those small features need it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/methods/particles/sampling/size_bounds.h"
#include "isobench/methods/sizing/critical_points/critical_points.h"

namespace isobench::particles {

struct Spacing;

/// One place a point, in the same order. Edges of 2ε times a point's distance from the surface (equation 1 of Meyer,
/// Kirby, Whitaker 2007: the distance is what λ and 1/κ are there), but not below `least` mm; no flat part, voxels as
/// units.
std::vector<SizeBound> critical_bounds(const std::vector<CriticalPoint>& points, double epsilon, double least,
                                       double voxel);

/// Adds seeds around the points, whose places are the first of `places`, until none has room for another, apart from
/// each other and from `seeds` by most of the spacing; sheets that face each other do not count. The same for any
/// number of threads.
void add_critical_seeds(const std::vector<CriticalPoint>& points, const SizeBounds& places, const Isosurface& surface,
                        const Spacing& spacing, std::uint64_t seed, std::vector<Eigen::Vector3d>& seeds);

}  // namespace isobench::particles
