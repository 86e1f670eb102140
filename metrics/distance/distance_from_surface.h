// Distance of the surface F = c to a mesh: the other way round from distance.h, and what tells that a mesh has missed
// something. Both ways together bound the Hausdorff distance (Cignoni, Rocchini, Scopigno 1998).
#pragma once

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

struct DistanceFromSurface {
  double mean = 0.0;  ///< mm, by area of the surface
  double max = 0.0;   ///< mm
};

/// From the vertices of marching cubes on the data's lattice, which lie on F = c, and from the centroids of its
/// triangles, projected there: a voxel's width apart or less. A triangle's mean weighs these by 1/12 and 3/4 each,
/// exact where the distance is quadratic; of more than a million triangles so many, evenly, stand for all. The distance
/// of a place is that to the nearest point of any triangle with area; where the mesh has none, the length of the
/// volume. Throws Cancelled. Cost: one tree over the triangles and a few microseconds a place, with all threads.
DistanceFromSurface measure_distance_from_surface(const TriangleMesh& mesh, const Isosurface& surface,
                                                  Monitor& monitor);

}  // namespace isobench
