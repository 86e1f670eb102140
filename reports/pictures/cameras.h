// The views from which meshes are drawn.
#pragma once

#include <cstddef>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/reports/pictures/render.h"

namespace isobench {

/// A view of several meshes as a whole, from a corner in front, with a small margin. The meshes need not belong to one
/// surface.
View view_of_all(const std::vector<const TriangleMesh*>& meshes);
/// A view from the same direction of the part of the mesh that is nearest to the eye, so close that edges of this
/// length can be told apart.
View closer_view(const View& whole, const TriangleMesh& mesh, double edge_length);
/// A view perpendicular to a triangle, with its neighbours around it.
View view_of_triangle(const TriangleMesh& mesh, std::size_t triangle);
/// A view along the surface's normal of the vertex nearest to a place, so close that edges of this length can be told
/// apart.
View view_of_place(const TriangleMesh& mesh, const Eigen::Vector3d& place, double edge_length);

/// Mean length of the triangles' edges, mm.
double mean_edge(const TriangleMesh& mesh);

}  // namespace isobench
