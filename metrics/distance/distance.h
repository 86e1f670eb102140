// Distance of a mesh to the surface F = c, at the vertices, edge midpoints and centroids of the triangles. Newton's
// steps along the gradient go from a point to the surface; the distance is that to the point reached. A triangle's mean
// weighs a vertex by 1/20, an edge midpoint by 2/15 and the centroid by 9/20, which is exact where the distance is
// cubic; the mesh's mean weighs triangles by area. Distances below 1e-6 voxel count as 0.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/metrics/mesh_edges/mesh_edges.h"

namespace isobench {

struct DistanceFigures {
  double mean = 0.0;        ///< mm; NaN where the mesh has no area
  double max = 0.0;         ///< mm
  double vertex_max = 0.0;  ///< mm, of vertices that have a triangle
  double mean_voxels = 0.0;
  double max_voxels = 0.0;
  std::size_t points = 0;       ///< at which the distance was taken
  std::size_t unprojected = 0;  ///< points from which Newton's steps did not reach the surface; |f|/|∇f| is taken there
  /// False if no point could be projected: the other figures then say nothing of the surface.
  bool any_projected() const { return unprojected < points; }
};

/// Whether the mesh can be none of this surface: it is farther away than it is long, or its bounding box lies outside
/// of the volume.
bool is_elsewhere(const TriangleMesh& mesh, const Isosurface& surface, const DistanceFigures& figures);

/// Why a mesh may not be where its surface is: the boxes of mesh and volume differ in size as metres and mm do, or they
/// lie apart. A clause that begins with "; "; "" if the boxes do not tell.
std::string hint_of_boxes(const TriangleMesh& mesh, const Isosurface& surface);

/// If `at_vertices` is given, it receives one distance a vertex, in mm.
/// Cost: one projection for each vertex, edge and triangle, with all threads.
DistanceFigures measure_distance(const TriangleMesh& mesh, const MeshEdges& edges, const Isosurface& surface,
                                 std::vector<double>* at_vertices = nullptr);

}  // namespace isobench
