#include "isobench/metrics/mesh_edges/mesh_edges.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace isobench {

namespace {

template <class Visit>
void for_each_side(const TriangleMesh& mesh, Visit visit) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    if (is_collapsed(triangle)) continue;
    for (std::uint16_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangle[i];
      const std::uint32_t to = triangle[(i + 1U) % 3U];
      visit(HalfEdge{std::min(from, to), std::max(from, to), static_cast<std::uint32_t>(t), i, from < to});
    }
  }
}

}  // namespace

std::vector<HalfEdge> sorted_half_edges(const TriangleMesh& mesh) {
  // A counting sort by the lower end, then each vertex's few sides by the other end.
  std::vector<std::size_t> start(mesh.vertices.size() + 1, 0);
  for_each_side(mesh, [&](const HalfEdge& side) { ++start[side.low + 1]; });
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
  std::vector<HalfEdge> sides(start.back());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for_each_side(mesh, [&](const HalfEdge& side) { sides[next[side.low]++] = side; });
  tbb::parallel_for(std::size_t{0}, mesh.vertices.size(), [&](std::size_t v) {
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(start[v]),
              sides.begin() + static_cast<std::ptrdiff_t>(start[v + 1]), [](const HalfEdge& a, const HalfEdge& b) {
                return std::pair(a.high, a.triangle) < std::pair(b.high, b.triangle);
              });
  });
  return sides;
}

MeshEdges mesh_edges(const TriangleMesh& mesh) { return mesh_edges(mesh, sorted_half_edges(mesh)); }

MeshEdges mesh_edges(const TriangleMesh& mesh, const std::vector<HalfEdge>& sides) {
  MeshEdges edges;
  edges.ends.reserve(sides.size() / 2 + 1);
  edges.of_triangle.assign(mesh.triangles.size(), {MeshEdges::none, MeshEdges::none, MeshEdges::none});
  for (std::size_t begin = 0; begin < sides.size();) {
    const std::size_t end = edge_end(sides, begin);
    for (std::size_t s = begin; s < end; ++s) {
      edges.of_triangle[sides[s].triangle][sides[s].corner] = static_cast<std::uint32_t>(edges.ends.size());
    }
    edges.ends.push_back({sides[begin].low, sides[begin].high});
    begin = end;
  }
  return edges;
}

}  // namespace isobench
