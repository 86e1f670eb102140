// One number for a whole mesh.
#pragma once

#include <string>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

/// SHA-256 over the numbers of vertices and triangles, the coordinates (doubles, bit for bit) and the corners, in their
/// order; data arrays do not count. Equal for equal meshes on machines of one byte order, and for a mesh read back from
/// VTP, which keeps doubles.
std::string checksum(const TriangleMesh& mesh);

}  // namespace isobench
