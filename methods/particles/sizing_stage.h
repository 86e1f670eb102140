// The first stage of the pipeline: the sizing field that particles follow, and the critical points of F near which it
// is too coarse.
#pragma once

#include <memory>
#include <vector>

#include "isobench/methods/method.h"
#include "isobench/methods/particles/sampling/sized_surface.h"
#include "isobench/methods/sizing/critical_points/critical_points.h"

namespace isobench::particles {

/// Whether the parameters ask for a field other than the one by which all methods are measured.
bool has_own_sizing(const MeshingTask& task);

/// The field that particles follow. Stage "sizing". The mesh is measured against the task's own field in any case.
std::shared_ptr<const SizingField> follow_sizing(const MeshingTask& task, Monitor& monitor);

/// The critical points of F at which the features that decide the topology are smaller than the sizing's floor. Empty
/// if `critical_floor` does not allow smaller sizes, or if the sizing is uniform. Stage "critical points"; counters
/// "floor/places" and "floor/places left"; artefact "floor-places".
std::vector<CriticalPoint> critical_points_below_floor(const MeshingTask& task, const SizingField& field,
                                                       Monitor& monitor);

/// The least h near critical points, mm.
double critical_floor(const MeshingTask& task);

/// The surface with the sizing of the task; h is bounded near the critical points.
SizedSurface size_surface(const MeshingTask& task, const SizingField& field,
                          const std::vector<CriticalPoint>& below_floor);

}  // namespace isobench::particles
