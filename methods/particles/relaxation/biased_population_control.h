// Population control as published (Meyer, Kirby, Whitaker 2007, section 3.3): random, with a bias by energy. The
// constants come from the implementations of the same authors.
#pragma once

#include <cstdint>

#include "isobench/methods/particles/relaxation/population_control.h"

namespace isobench::particles {

/// Draws U(0, 1) · (E − E_ideal)/E_ideal for each particle. Below −0.35 the particle splits in two; above 0.75 it is
/// deleted. A particle without any neighbour gets three new ones. The particle with the largest value is deleted first.
/// Each deletion lowers the energies of its neighbours at once, so two that crowd each other are not both deleted.
///
/// A new particle is placed at a distance of about h in the widest angle around its parent. It is dropped if it is
/// nearer than 0.5 h to another particle. Otherwise two parents beside one gap would fill it twice. `seed` and `round`
/// determine the random numbers.
PopulationChange control_population_by_bias(const SizedSurface& sized, Particles& particles, std::uint64_t seed,
                                            std::uint64_t round);

}  // namespace isobench::particles
