// Relaxation of one particle after the other, as published (Meyer, Kirby, Whitaker 2007, section 3.3; Meyer, Georgel,
// Whitaker 2005): the `gauss-seidel` choice of the parameter `relaxation`.
#pragma once

#include <vector>

#include "isobench/foundation/monitor.h"
#include "isobench/methods/particles/relaxation/particles.h"

namespace isobench::particles {

/// A call ends when one of the two is reached.
struct StopCriterion {
  double relative_fall = 1.5e-4;  ///< the total energy falls by less than this share of itself in a sweep
  int sweeps = 50;                ///< maximum number of sweeps
};

struct GaussSeidelResult {
  int sweeps = 0;
  double energy = 0.0;  ///< total energy of the particles at the end; each pair counts once
};

/// Moves the particles on F = c to lower energy. In a sweep, each particle in turn tries the step dx = h P(−f/λ) and is
/// projected to F = c. Here f is the sum of E′ along the unit vectors from its neighbours, P the projection onto its
/// tangent plane, and h its spacing. If its energy falls, the step is taken and λ is divided by ten; if not, λ is
/// multiplied by ten and the particle tries again. Each particle has its own λ, 0.1 at the start. A step is refused if
/// it is longer than h, if it leads to another sheet, or if it leads farther than the neighbour lists cover.
///
/// E is symmetric, so no sweep raises the total energy. Runs on one thread, because the result depends on the order of
/// the particles.
///
/// `fixed` is empty or has one entry per particle: a particle with an entry other than 0 acts on others but stays.
/// Traces after each sweep: "energy", the mean over all particles, and "moves", the share of particles that moved.
GaussSeidelResult relax_by_gauss_seidel(const SizedSurface& sized, Particles& particles, Monitor& monitor,
                                        const StopCriterion& stop = {}, const std::vector<char>& fixed = {});

}  // namespace isobench::particles
