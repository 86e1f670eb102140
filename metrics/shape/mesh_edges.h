// The edges of a mesh as flat sorted arrays: what valence, edge lengths, distance and topology have in common.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

/// One side of a triangle, from corner `corner` to the next; low < high whichever way the triangle runs.
struct HalfEdge {
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  std::uint32_t triangle = 0;
  std::uint16_t corner = 0;
  bool forward = false;  ///< the triangle runs from low to high
};

/// Whether two corners of a triangle are the same vertex. Such a triangle is no triangle of the mesh as a complex:
/// edges, valence and topology leave it out.
inline bool is_collapsed(const Triangle& triangle) {
  return triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
}

/// The sides of all triangles that are not collapsed, sorted by (low, high, triangle): the sides of one edge lie
/// together. Linear time but for short sorts around each vertex; precondition: indices in range.
std::vector<HalfEdge> sorted_half_edges(const TriangleMesh& mesh);

/// The index behind the last half-edge of the edge that begins at `begin`.
inline std::size_t edge_end(const std::vector<HalfEdge>& sides, std::size_t begin) {
  std::size_t end = begin + 1;
  while (end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high) ++end;
  return end;
}

/// The distinct edges (low, high) with the edge of each side of each triangle.
struct MeshEdges {
  static constexpr std::uint32_t none = 0xffffffffU;
  std::vector<std::array<std::uint32_t, 2>> ends;
  /// Edge from corner i to corner i+1 of each triangle; `none` for collapsed triangles.
  std::vector<std::array<std::uint32_t, 3>> of_triangle;
};
MeshEdges mesh_edges(const TriangleMesh& mesh);

}  // namespace isobench
