// Distance of a mesh to the surface F = c: |f|/|∇f| polished by projection (Newton's steps along the gradient until
// they reach the surface; the distance is to where they end), at the vertices, edge midpoints and centroids of the
// triangles. A triangle's mean weighs these by 1/20, 2/15 and 9/20 each (exact where the distance is cubic), the mesh's
// mean weighs triangles by area. What is nearer than 1e-6 voxel counts as 0.
#pragma once

#include <cstddef>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

struct DistanceFigures {
  double mean = 0.0;        ///< mm
  double max = 0.0;         ///< mm
  double vertex_max = 0.0;  ///< mm, of the triangles' vertices alone: the vertices should lie on the surface
  double mean_voxels = 0.0;
  double max_voxels = 0.0;
  std::size_t unprojected = 0;  ///< sample points whose projection did not converge; |f|/|∇f| is taken there
};

/// Where `at_vertices` is given it receives one distance a vertex, in mm.
/// Cost: one projection for each vertex, edge and triangle, with all threads.
DistanceFigures measure_distance(const TriangleMesh& mesh, const Isosurface& surface,
                                 std::vector<double>* at_vertices = nullptr);

}  // namespace isobench
