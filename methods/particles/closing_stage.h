// The stage "triangulation" of the pipeline: a closed mesh through the particles.
#pragma once

#include "isobench/methods/method.h"
#include "isobench/methods/particles/relaxation/particles.h"

namespace isobench::particles {

/// Closes the particles as the parameter `surface` says. With `labelled-delaunay`, the cure (stage "cure") adds bounds
/// to `sized` and changes the particles. Counters "cocone/…" or "cure/…", and "particles/unused" for particles without
/// a triangle.
TriangleMesh close_particles(const MeshingTask& task, SizedSurface& sized, Particles particles, Monitor& monitor);

}  // namespace isobench::particles
