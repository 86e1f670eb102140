// Where meshes are looked at from.
#pragma once

#include <cstddef>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/reports/pictures/render.h"

namespace isobench {

/// The whole of several meshes, from a corner in front, with a little room around. They need not be of one surface.
View view_of_all(const std::vector<const TriangleMesh*>& meshes);
/// The place of those meshes that is nearest to the eye of that view, so near that edges of this length can be told
/// apart.
View closer_view(const View& whole, const TriangleMesh& mesh, double edge_length);
/// Straight onto a triangle, with its neighbours around it.
View view_of_triangle(const TriangleMesh& mesh, std::size_t triangle);

/// Mean length of the triangles' edges, mm.
double mean_edge(const TriangleMesh& mesh);

}  // namespace isobench
