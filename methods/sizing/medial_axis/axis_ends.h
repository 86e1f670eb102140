// The ends of the medial axis: centres of curvature of the surface's ridges and valleys. Section 2 of Meyer, Kirby,
// Whitaker 2007 counts them as part of the axis, but the algorithm of section 3.1 does not find them.
#pragma once

#include "isobench/foundation/monitor.h"
#include "isobench/methods/sizing/medial_axis/shrinking_balls.h"

namespace isobench {

/// The centres of the osculating balls that contain no other sample, with radii up to `cap` (mm). The radius
/// belongs to the largest principal curvature on the ball's side of the surface.
///
/// Foot points are found by a threshold on an angle. Towards an end this angle goes to 0, so foot points stop short of
/// the end by about the radius of the ridge: many voxels along wide bones.
///
/// Curvatures come from F. A ball is empty if it contains no sample deeper than 1e-6 of its radius. Multi-threaded; the
/// points are in the order of the samples for any number of threads. Cost: up to two nearest-neighbour queries a
/// sample.
MedialBalls axis_ends(const SurfaceSamples& samples, double cap, Monitor& monitor);

}  // namespace isobench
