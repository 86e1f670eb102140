// Relaxation by damped Newton steps of all particles at once: the `newton` choice of the parameter `relaxation`.
#pragma once

#include <vector>

#include "isobench/foundation/monitor.h"
#include "isobench/methods/particles/relaxation/particles.h"

namespace isobench::particles {

/// Moves the particles on F = c to lower energy. In a sweep, every particle takes one damped Newton step with momentum
/// in its tangent plane, at most 0.3 times its spacing, and one Newton step back to F = c. A scalar replaces the
/// Hessian: the sum of the stiffness (potential.h) over the neighbours. All particles step from the same positions
/// (Jacobi), so the result does not depend on the number of threads. After the last sweep all particles that are not
/// fixed are projected to within 1e-6 voxel of F = c; one that has strayed so far that its projection does not end
/// there returns to where it was before the first sweep.
///
/// `fixed` is empty or has one entry per particle: a particle with an entry other than 0 acts on others but stays.
/// Trace "energy": for each sweep, the mean energy of all particles before it; a fixed particle counts as 0.
void relax_by_newton(const SizedSurface& sized, Particles& particles, int sweeps, Monitor& monitor,
                     const std::vector<char>& fixed = {});

}  // namespace isobench::particles
