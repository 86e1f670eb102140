// Population control: more particles where there are too few for the sizing, fewer where there are too many.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "isobench/methods/particles/sampling/relaxation.h"

namespace isobench::particles {

struct PopulationChange {
  std::size_t split = 0;
  std::size_t deleted = 0;
};

/// Splits particles with less than `split_below` of the ideal energy and deletes those with more than `delete_above` of
/// it. A new particle is placed in the largest angular gap around its parent at distance h, projected, and given up
/// where it would stand nearer than 0.5 h to another; of neighbouring crowded particles only one is deleted at a time,
/// so that no hole opens. Where `fixed` is given (one entry a particle, and one of each afterwards), particles with an
/// entry other than 0 neither split nor vanish. Deterministic for any number of threads.
PopulationChange control_population(const Isosurface& surface, const Spacing& spacing, Particles& particles,
                                    double split_below, double delete_above, std::vector<char>* fixed = nullptr);

/// Neighbours of i on its own sheet.
std::vector<std::uint32_t> ring(const Particles& particles, const NeighbourLists& near, std::size_t i);
/// The middle of the widest angle around particle i in which none of these neighbours stands, as a unit tangent.
Eigen::Vector3d widest_gap(const Particles& particles, const std::vector<std::uint32_t>& neighbours, std::size_t i);

}  // namespace isobench::particles
