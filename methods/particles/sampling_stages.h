// The stages "seeds" and "relaxation" of the pipeline: particles on F = c, evenly packed at the spacing of the sizing.
#pragma once

#include <vector>

#include "isobench/methods/method.h"
#include "isobench/methods/particles/relaxation/population_control.h"
#include "isobench/methods/particles/sampling/sized_surface.h"
#include "isobench/methods/sizing/critical_points/critical_points.h"

namespace isobench::particles {

/// The parameters `split_below` and `delete_above`, for the newton relaxation and the cure.
PopulationLimits population_limits(const MeshingTask& task);

/// Particles at the start, from the parameter `seeds`, and more of them near the critical points; with a cure, also on
/// components of the surface that have too few (component_seeds.h, which adds bounds to `sized`). Counters
/// "particles/seeds" and "particles/small components". Precondition: the first bounds of `sized` belong to the points
/// `below_floor`.
Particles seed_particles(const MeshingTask& task, SizedSurface& sized, const TriangleMesh& lattice_mesh,
                         const std::vector<CriticalPoint>& below_floor, Monitor& monitor);

/// Moves particles and controls their number, as the parameter `relaxation` says. Traces "energy" and "particles";
/// counters "particles/split" and "particles/deleted".
void relax_particles(const MeshingTask& task, const SizedSurface& sized, Particles& particles, Monitor& monitor);

}  // namespace isobench::particles
