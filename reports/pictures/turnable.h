// Small mesh files for the 3D view of the page, read by reports/page/view_3d.js. The same mesh gives the same bytes.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

/// A mesh with a value between 0 and 1 for each triangle.
struct ValuedMesh {
  TriangleMesh mesh;
  std::vector<double> values;
};

/// A simplified copy with at most `most` triangles, and not many fewer. Each triangle gets the smallest value of the
/// triangles that it replaces. A mesh with no more than `most` triangles is returned unchanged. The method is VTK's
/// quadric clustering, which is fast and works on any mesh.
ValuedMesh simplified(ValuedMesh mesh, std::size_t most);

/// The part of a mesh around a triangle, unchanged, with at most `most` triangles.
ValuedMesh around(const ValuedMesh& mesh, std::size_t triangle, std::size_t most);

/// The file, little-endian:
///   number of vertices, number of triangles (uint32);
///   lowest corner of the bounding box, its longest side (float32, mm);
///   for each vertex x, y and z, relative to the corner, in 1/65535 of that side (uint16);
///   for each triangle three corners, each as a base-128 number: 0 for the next vertex that no triangle has used yet,
///   else how far the vertex lies before that one;
///   for each triangle its value in 1/255 (uint8).
/// Cost: about nine bytes for each triangle.
std::string turnable(const ValuedMesh& mesh);

}  // namespace isobench
