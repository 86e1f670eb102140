// Relaxing a small part of the particles again, where h turned out too large.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "isobench/foundation/monitor.h"
#include "isobench/methods/particles/relaxation/population_control.h"

namespace isobench::particles {

/// Makes h smaller around the points: 0.7 times its value within 1.2 times the spacing, rising again beyond. h does not
/// become smaller than `least_h` mm. Of points within half a spacing of each other, only the first counts.
void shrink_around(const std::vector<Eigen::Vector3d>& points, SizedSurface& sized, double least_h = 0.0);

/// Particles to remove from a set and particles to add to it.
struct Exchange {
  std::vector<std::uint32_t> removed;  ///< indices, ascending
  Particles added;
};

/// Makes h smaller around the points (shrink_around) and relaxes the particles within twice the spacing of a point,
/// with population control; all other particles stay. Returns the relaxed particles in exchange for those that were
/// within twice the spacing. Time is linear in the number of particles, with a small factor; most of it is spent on the
/// relaxed ones. The result does not depend on the number of threads. The traces of `monitor` stay as they are.
Exchange relax_around(const std::vector<Eigen::Vector3d>& points, SizedSurface& sized, const Particles& particles,
                      double least_h, const PopulationLimits& population, Monitor& monitor);

}  // namespace isobench::particles
