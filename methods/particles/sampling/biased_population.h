// Population control of the published particles (Meyer, Kirby, Whitaker 2007, section 3.3; constants of the same
// authors' implementations): chance, biased by energy, splits and deletes.
#pragma once

#include <cstdint>

#include "isobench/methods/particles/sampling/population.h"

namespace isobench::particles {

/// For each particle U(0, 1) · (E − E_ideal)/E_ideal: below −0.35 it splits in two, above 0.75 it is deleted; one that
/// nobody acts on gets three neighbours. The largest goes first, and each deletion lowers its neighbours' energies at
/// once: two that crowd each other do not both vanish. A new particle stands at about h in the widest angle around its
/// parent, and is given up nearer than 0.5 h to another: two parents on one gap would fill it twice, with particles
/// that never part. `seed` and `round` determine the chances.
PopulationChange control_population_by_bias(const Isosurface& surface, const Spacing& spacing, Particles& particles,
                                            std::uint64_t seed, std::uint64_t round);

}  // namespace isobench::particles
