// Population control of the `newton` relaxation: adds particles where there are too few for the sizing, and deletes
// particles where there are too many.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "isobench/methods/particles/relaxation/particles.h"

namespace isobench::particles {

/// Limits on the energy of a particle, in units of the ideal energy.
struct PopulationLimits {
  double split_below = 0.6;   ///< a particle with less energy splits
  double delete_above = 1.6;  ///< a particle with more energy is deleted
};

struct PopulationChange {
  std::size_t split = 0;
  std::size_t deleted = 0;
};

/// Splits and deletes particles according to the limits. A split adds a particle at distance h in the widest angular
/// gap around its parent and projects it. The particle is not added if it would be nearer than 0.5 h to its parent or
/// to a neighbour of its parent. A call does not delete two neighbours, so that no hole opens.
///
/// `fixed` is null or has one entry per particle, before and after the call: a particle with an entry other than 0
/// neither splits nor is deleted. The result does not depend on the number of threads.
PopulationChange control_population(const SizedSurface& sized, Particles& particles, const PopulationLimits& limits,
                                    std::vector<char>* fixed = nullptr);

/// The neighbours of particle i that are on its own sheet.
std::vector<std::uint32_t> same_sheet_neighbours(const Particles& particles, const NeighbourLists& near, std::size_t i);
/// The middle of the widest angle around particle i that holds none of these neighbours, as a unit tangent.
Eigen::Vector3d widest_gap(const Particles& particles, const std::vector<std::uint32_t>& neighbours, std::size_t i);

}  // namespace isobench::particles
