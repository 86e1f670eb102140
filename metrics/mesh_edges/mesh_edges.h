// The edges of a mesh as flat sorted arrays. Valence, edge lengths, distance and topology are counted from these.
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

/// Whether two corners of a triangle are the same vertex. Edges, valence and topology leave such triangles out.
inline bool is_collapsed(const Triangle& triangle) {
  return triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
}

/// The sides of all triangles that are not collapsed, sorted by (low, high, triangle), so that the sides of one edge
/// are neighbours. Linear time, apart from a short sort at each vertex. Precondition: indices in range.
std::vector<HalfEdge> sorted_half_edges(const TriangleMesh& mesh);

/// One past the last half-edge of the edge whose first half-edge is `begin`.
inline std::size_t edge_end(const std::vector<HalfEdge>& sides, std::size_t begin) {
  std::size_t end = begin + 1;
  while (end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high) ++end;
  return end;
}

/// Why a mesh has no figures of its edges, as FigureDeclaration::unmeasured says it.
inline constexpr const char* no_edges = "all triangles of the mesh have collapsed to an edge or a point";

/// The distinct edges, each as (low, high), and which edge each side of a triangle is.
struct MeshEdges {
  static constexpr std::uint32_t none = 0xffffffffU;
  std::vector<std::array<std::uint32_t, 2>> ends;
  /// Edge from corner i to corner i+1 of each triangle; `none` for collapsed triangles.
  std::vector<std::array<std::uint32_t, 3>> of_triangle;
};
/// `sides` are sorted_half_edges() of the mesh.
MeshEdges mesh_edges(const TriangleMesh& mesh, const std::vector<HalfEdge>& sides);
MeshEdges mesh_edges(const TriangleMesh& mesh);

}  // namespace isobench
