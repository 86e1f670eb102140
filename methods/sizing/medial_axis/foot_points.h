// The medial axis by foot points (Meyer, Kirby, Whitaker 2007, section 3.1): where the nearest surface point of two
// points on one line through a lattice cell changes, the line crosses the axis in between.
#pragma once

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/sizing/medial_axis/shrinking_balls.h"

namespace isobench {

/// Points of the medial axis on both sides of the surface, and their distances from it. For every lattice node q that
/// is not on the surface: p is the surface point nearest to q, q* where the ray from p through q leaves the cell that
/// it enters at q, p* the surface point nearest to q*. If the lines pq and p*q* make an angle of more than acos 0.9,
/// the axis lies between q and q*, at m = p + s u, u = (q − p)/|q − p|, where m is as far from p as from the tangent
/// plane at p*. Foot points start from the nearest of `samples`; where there are none, there is no axis.
///
/// As published, the ends of the axis, where the angle closes, are not found (axis_ends.h finds them). A shape without
/// an axis (a plane) gives no points. Multi-threaded; points come in the order of the nodes, whatever the
/// number of threads. Cost: two nearest-neighbour queries a lattice node, and a few projections near the axis.
///
/// The points lie about a node apart, so the distance to the nearest of them is more than that to the axis: for λ of a
/// voxel or two by a tenth to a half, and in sheets thinner than a voxel there may be no node to find any. With
/// `halvings` > 0, beyond what is published, the nodes of a lattice of half the spacing are asked, too, within two
/// cells of the surface, of a quarter within two of the smaller cells, and so on: where λ is small, the points are
/// dense. Each halving costs about as much as the lattice.
MedialBalls foot_point_axis(const Isosurface& surface, const SurfaceSamples& samples, Monitor& monitor,
                            int halvings = 0);

}  // namespace isobench
