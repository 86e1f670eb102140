// The medial axis from foot points (Meyer, Kirby, Whitaker 2007, section 3.1). The foot of a point is the surface point
// nearest to it. If two points on a line have feet on different parts of the surface, the line crosses the axis between
// them.
#pragma once

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/sizing/medial_axis/shrinking_balls.h"

namespace isobench {

/// Points of the medial axis on both sides of the surface, and their distances from it. For every lattice node q that
/// is not on the surface, p is the foot of q, q* is the point where the ray from p through q leaves the cell that it
/// enters at q, and p* is the foot of q*. If the lines pq and p*q* make an angle of more than acos 0.9, the axis is
/// between q and q*: at m = p + s u with u = (q − p)/|q − p|, where m is as far from p as from the tangent plane at p*.
/// The search for a foot starts from the nearest of `samples`; without samples there is no axis.
///
/// As published, this does not find the ends of the axis, where the angle goes to 0; axis_ends.h finds them. A plane
/// has no axis and gives no points. Multi-threaded; the points are in the order of the nodes for any number of threads.
/// Cost: two nearest-neighbour queries per lattice node, and a few projections near the axis.
///
/// The points are about one node apart, so the distance to the nearest of them exceeds the distance to the axis: by a
/// tenth to a half where λ is a voxel or two. Sheets thinner than a voxel may have no point at all. `halvings` > 0,
/// which the paper does not have, adds the nodes of a lattice with half the spacing within two cells of the surface,
/// then the nodes of a lattice with a quarter of the spacing within two of the smaller cells, and so on. So the points
/// are dense where λ is small. Each halving costs about as much as the whole lattice.
MedialBalls foot_point_axis(const Isosurface& surface, const SurfaceSamples& samples, Monitor& monitor,
                            int halvings = 0);

}  // namespace isobench
