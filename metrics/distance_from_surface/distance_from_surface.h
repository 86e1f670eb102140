// Distance of the surface F = c to a mesh. It shows parts of the surface that the mesh misses; the distance in the
// other direction (distance.h) does not. Both together bound the Hausdorff distance (Cignoni, Rocchini, Scopigno 1998).
#pragma once

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

struct DistanceFromSurface {
  double mean = 0.0;  ///< mm, by area of the surface
  double max = 0.0;   ///< mm
};

/// Taken at the vertices of marching cubes on the data's lattice, which lie on F = c, and at the centroids of its
/// triangles, projected to F = c. These points are at most a voxel apart. A triangle's mean weighs a vertex by 1/12 and
/// the centroid by 3/4, which is exact where the distance is quadratic. If there are more than a million triangles,
/// every n-th is used, so that at most a million are. The distance is to the nearest point of any triangle with area;
/// if the mesh has none, it is the length of the volume's diagonal. Throws Cancelled. Cost: one tree over the triangles
/// and some microseconds a point, all threads.
DistanceFromSurface measure_distance_from_surface(const TriangleMesh& mesh, const Isosurface& surface,
                                                  Monitor& monitor);

}  // namespace isobench
