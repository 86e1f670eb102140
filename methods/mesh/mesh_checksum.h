// A checksum that tells whether two meshes are equal.
#pragma once

#include <string>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

/// SHA-256 over the number of vertices, the number of triangles, the coordinates (bit patterns of doubles) and the
/// corners, in their order. Data arrays are not included. Equal meshes have equal checksums on all machines of one byte
/// order, also after a round trip through VTP, which stores doubles.
std::string checksum(const TriangleMesh& mesh);

}  // namespace isobench
