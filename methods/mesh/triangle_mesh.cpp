#include "isobench/methods/mesh/triangle_mesh.h"

#include <utility>

#include "isobench/datasets/volume.h"
#include "isobench/foundation/union_find.h"

namespace isobench {

namespace {

// A reflection makes counter-clockwise triangles clockwise.
TriangleMesh flipped_if_mirrored(TriangleMesh mesh, const Lattice& lattice) {
  if (!lattice.right_handed()) {
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

}  // namespace

TriangleMesh to_world(TriangleMesh mesh, const Lattice& lattice) {
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = lattice.to_world(vertex);
  mesh.space = lattice.space;
  return flipped_if_mirrored(std::move(mesh), lattice);
}

TriangleMesh to_local(TriangleMesh mesh, const Lattice& lattice) {
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = lattice.to_local(vertex);
  mesh.space.clear();
  return flipped_if_mirrored(std::move(mesh), lattice);
}

std::vector<std::uint32_t> component_roots(const TriangleMesh& mesh) {
  UnionFind sets(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles) {
    sets.unite(t[0], t[1]);
    sets.unite(t[0], t[2]);
  }
  std::vector<std::uint32_t> roots(mesh.vertices.size());
  for (std::uint32_t n = 0; n < roots.size(); ++n) roots[n] = sets.find(n);
  return roots;
}

std::size_t drop_unused_vertices(TriangleMesh& mesh) {
  std::vector<char> used(mesh.vertices.size(), 0);
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) used[v] = 1;
  }
  std::vector<std::uint32_t> moved(mesh.vertices.size(), 0);
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (used[v] == 0) continue;
    mesh.vertices[kept] = mesh.vertices[v];
    for (auto& [name, values] : mesh.vertex_data) values[kept] = values[v];
    moved[v] = kept++;
  }
  const std::size_t dropped = mesh.vertices.size() - kept;
  mesh.vertices.resize(kept);
  for (auto& [name, values] : mesh.vertex_data) values.resize(kept);
  for (Triangle& triangle : mesh.triangles) {
    for (std::uint32_t& v : triangle) v = moved[v];
  }
  return dropped;
}

}  // namespace isobench
