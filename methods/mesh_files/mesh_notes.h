// What somebody should know of a mesh before they trust its figures, or the file that they write.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

/// A sentence for each fault of the mesh as a whole: it is inside out (closed, oriented alike, and its volume is
/// negative); no two of its triangles share an edge; triangles name a vertex twice; vertices have no triangle. Cost: a
/// sort of the edges.
std::vector<std::string> notes_on(const TriangleMesh& mesh);

/// What the mesh loses if write_mesh() writes it to this path and a program reads it back, in one sentence with the
/// path first; "" if it loses nothing that matters. STL holds single precision and no vertex numbers: far from the
/// origin vertices move, become one, and triangles collapse. Moves of less than 1 % of the mean edge do not matter.
/// Cost: a sort of the vertices.
std::string loss_in_file(const TriangleMesh& mesh, const std::filesystem::path& path);

}  // namespace isobench
