// Where sheets of the medial axis end: at centres of curvature of the surface's ridges and valleys (Meyer, Kirby,
// Whitaker 2007, section 2, count them as the axis's closure; section 3.1 leaves them out of what is looked for).
#pragma once

#include "isobench/foundation/monitor.h"
#include "isobench/methods/sizing/medial_axis/shrinking_balls.h"

namespace isobench {

/// The centres of those osculating balls that hold no other sample, on the side towards which the surface bends most
/// there; radii up to `cap` (mm). Towards such an end the angle between two foot points closes, so that a threshold on
/// it stops short of the end, by as much as the ridge is round: along wide bones by many voxels.
///
/// Curvature comes from F, emptiness from the samples: a ball counts as empty if it is so but for 1e-6 of its radius.
/// Multi-threaded; points come in the order of the samples, whatever the number of threads. Cost: up to two
/// nearest-neighbour queries a sample.
MedialBalls axis_ends(const SurfaceSamples& samples, double cap, Monitor& monitor);

}  // namespace isobench
