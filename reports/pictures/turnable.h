// Meshes as the page's script reads and turns them (view.js): small, and the same bytes for the same mesh.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

/// A mesh with a value from 0 to 1 for each triangle.
struct ValuedMesh {
  TriangleMesh mesh;
  std::vector<double> values;
};

/// A copy of about as many triangles as asked for, at most; each carries the least value of the triangles that it
/// stands for. A mesh that has no more is returned as it is. By VTK's quadric clustering: quick, and any mesh will do.
ValuedMesh simplified(ValuedMesh mesh, std::size_t most);

/// The triangles around one of them, as they are.
ValuedMesh around(const ValuedMesh& mesh, std::size_t triangle, std::size_t most);

/// Little-endian: the numbers of vertices and triangles (uint32), the lowest corner of the box and its longest side
/// (float32, mm); of each vertex x, y and z in 65535ths of that side (uint16); of each triangle three corners, each as
/// a base-128 number of how far it lies behind the next vertex that was not used yet; of each triangle its value in
/// 255ths. About nine bytes a triangle.
std::string turnable(const ValuedMesh& mesh);

}  // namespace isobench
