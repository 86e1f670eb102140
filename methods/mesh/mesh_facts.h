// Figures of a mesh for methods, which cannot include metrics/: that floor is above methods/.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

struct MeshFacts {
  long euler = 0;                     ///< V − E + F; V includes unused vertices
  std::size_t components = 0;         ///< of vertices connected by triangles
  std::size_t open_edges = 0;         ///< edges not used equally often in both directions: holes, wrong orientation
  std::size_t nonmanifold_edges = 0;  ///< edges of more than two triangles
  double area = 0.0;                  ///< mm²
  double volume = 0.0;                ///< mm³, positive where triangles are counter-clockwise from outside
};

namespace mesh_facts_detail {

struct DirectedEdge {
  std::uint32_t low, high;
  bool forward;
  bool operator<(const DirectedEdge& other) const { return low != other.low ? low < other.low : high < other.high; }
};

inline std::vector<DirectedEdge> sorted_edges(const TriangleMesh& mesh) {
  std::vector<DirectedEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [low, high] = std::minmax(t[c], t[(c + 1) % 3]);
      edges.push_back({low, high, low == t[c]});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

inline std::size_t count_components(const TriangleMesh& mesh) {
  const std::vector<std::uint32_t> roots = component_roots(mesh);
  std::size_t count = 0;
  for (std::uint32_t n = 0; n < roots.size(); ++n) count += roots[n] == n;
  return count;
}

}  // namespace mesh_facts_detail

inline MeshFacts mesh_facts(const TriangleMesh& mesh) {
  MeshFacts facts;
  const std::vector<mesh_facts_detail::DirectedEdge> edges = mesh_facts_detail::sorted_edges(mesh);
  long edge_count = 0;
  for (std::size_t n = 0; n < edges.size();) {
    std::size_t triangles = 0;
    long turns = 0;
    const mesh_facts_detail::DirectedEdge& edge = edges[n];
    for (; n < edges.size() && edges[n].low == edge.low && edges[n].high == edge.high; ++n) {
      ++triangles;
      turns += edges[n].forward ? 1 : -1;
    }
    ++edge_count;
    facts.open_edges += turns != 0;
    facts.nonmanifold_edges += triangles > 2;
  }
  facts.euler = static_cast<long>(mesh.vertices.size()) - edge_count + static_cast<long>(mesh.triangles.size());
  facts.components = mesh_facts_detail::count_components(mesh);
  for (const Triangle& t : mesh.triangles) {
    // From a point of the mesh: from a far origin, the tetrahedra would cancel and lose digits.
    const Eigen::Vector3d& first = mesh.vertices[mesh.triangles.front()[0]];
    const Eigen::Vector3d a = mesh.vertices[t[0]] - first;
    const Eigen::Vector3d b = mesh.vertices[t[1]] - first;
    const Eigen::Vector3d c = mesh.vertices[t[2]] - first;
    facts.area += 0.5 * (b - a).cross(c - a).norm();
    facts.volume += a.dot(b.cross(c)) / 6.0;
  }
  return facts;
}

}  // namespace isobench
