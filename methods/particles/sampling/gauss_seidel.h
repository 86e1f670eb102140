// The relaxation of the published particles (Meyer, Kirby, Whitaker 2007, section 3.3; Meyer, Georgel, Whitaker 2005):
// one particle after the other goes downhill from where the others are now.
#pragma once

#include <vector>

#include "isobench/methods/particles/sampling/relaxation.h"

namespace isobench::particles {

/// When a round is over.
struct RoundEnd {
  double settled = 1.5e-4;  ///< the energy of all falls by less than this much of itself in a sweep
  int sweeps = 50;          ///< or so many sweeps are done
};

struct Round {
  int sweeps = 0;
  double energy = 0.0;  ///< of all particles at the end: each pair counted once
};

/// Sweeps until the round is over. In a sweep every particle takes the step dx = h P(−f/λ), f the sum of E′ along the
/// unit vectors from its neighbours, P onto its tangent plane, and goes back to F = c. The step counts if the
/// particle's energy falls; else λ grows tenfold and it tries again. After a step that counts λ falls to a tenth. Each
/// particle has its own λ, 0.1 at first. Steps longer than h, to another sheet, or beyond what the neighbour lists
/// cover in one sweep do not count.
///
/// As E is symmetric, no sweep raises the energy of all. One thread: the order of the particles is part of the method.
/// Where `fixed` is given (one entry a particle), particles with an entry other than 0 act on others but stay.
/// Traces, once a sweep: "energy", the mean a particle, and "moves", the share of particles that moved.
Round relax_in_order(const Isosurface& surface, const Spacing& spacing, Particles& particles, Monitor& monitor,
                     const RoundEnd& end = {}, const std::vector<char>& fixed = {});

}  // namespace isobench::particles
