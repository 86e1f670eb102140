// The pictures of a results folder: each mesh by the same camera as the others of its dataset, and its worst triangle.
#pragma once

#include <filesystem>

#include "reports/arrangement.h"
#include "reports/picture.h"
#include "reports/render.h"

namespace isobench {

/// The whole of several meshes, from a corner in front, with a little room around. They need not be of one surface.
View view_of_all(const std::vector<const TriangleMesh*>& meshes);
/// The place of those meshes that is nearest to the eye of that view, so near that edges of this length can be told
/// apart.
View closer_view(const View& whole, const TriangleMesh& mesh, double edge_length);
/// Straight onto a triangle, with its neighbours around it.
View view_of_triangle(const TriangleMesh& mesh, std::size_t triangle);

/// Draws into <folder>/pictures what is not there yet, from the stored meshes, and removes what is of no mesh of these
/// any more. Of several seeds or repeats the first finished run is drawn. Cost: about half a second a mesh of 100,000
/// triangles and picture.
Pictures draw_pictures(const Arrangement& runs, const std::filesystem::path& folder);

}  // namespace isobench
