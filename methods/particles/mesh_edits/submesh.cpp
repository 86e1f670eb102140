#include "isobench/methods/particles/mesh_edits/submesh.h"

#include <algorithm>
#include <unordered_map>

namespace isobench::particles {

using Index = EditableMesh::Index;

Submesh extract_submesh(const EditableMesh& mesh, std::span<const Index> centres, int rings) {
  Submesh submesh;
  std::unordered_map<Index, Index> index_in_submesh;
  const auto add_vertex = [&](Index v) {
    const bool is_new = index_in_submesh.try_emplace(v, static_cast<Index>(submesh.vertices.size())).second;
    if (is_new) submesh.vertices.push_back(v);
  };
  for (const Index v : centres) add_vertex(v);
  std::size_t inner = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const std::size_t end = submesh.vertices.size();
    for (std::size_t n = inner; n < end; ++n) {
      const Index v = submesh.vertices[n];
      if (!mesh.movable(v)) continue;
      Index e = mesh.out(v);
      do {
        submesh.triangles.push_back(e / 3);
        add_vertex(mesh.target(e));
        e = mesh.turn(e);
      } while (e != mesh.out(v));
    }
    inner = end;
    if (ring == 0) {
      for (Index n = 0; n < submesh.vertices.size(); ++n) submesh.core.push_back(n);
    }
  }
  std::sort(submesh.triangles.begin(), submesh.triangles.end());
  submesh.triangles.erase(std::unique(submesh.triangles.begin(), submesh.triangles.end()), submesh.triangles.end());
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals;
  for (const Index v : submesh.vertices) {
    points.push_back(mesh.points[v]);
    normals.push_back(mesh.normals[v]);
  }
  std::vector<Triangle> triangles;
  for (const Index t : submesh.triangles) {
    const Triangle corners = mesh.triangle(t);
    triangles.push_back(
        {index_in_submesh.at(corners[0]), index_in_submesh.at(corners[1]), index_in_submesh.at(corners[2])});
  }
  submesh.mesh = EditableMesh(std::move(points), std::move(normals), triangles);
  for (Index n = 0; n < submesh.vertices.size(); ++n) {
    submesh.mesh.set_valence(n, mesh.valence(submesh.vertices[n]));
    // At a pinch, the submesh may show a single closed fan of several.
    if (mesh.fixed(submesh.vertices[n])) submesh.mesh.fix(n);
  }
  return submesh;
}

void put_back_submesh(EditableMesh& mesh, const Submesh& submesh) {
  std::vector<Index> index_in_mesh = submesh.vertices;
  for (Index n = 0; n < submesh.mesh.vertex_count(); ++n) {
    if (n >= index_in_mesh.size()) {
      index_in_mesh.push_back(mesh.add_vertex(submesh.mesh.points[n], submesh.mesh.normals[n]));
    } else if (submesh.mesh.movable(n)) {
      mesh.points[index_in_mesh[n]] = submesh.mesh.points[n];
      mesh.normals[index_in_mesh[n]] = submesh.mesh.normals[n];
    }
  }
  std::vector<Triangle> fresh;
  for (Index t = 0; 3 * t < submesh.mesh.half_edge_count(); ++t) {
    if (!submesh.mesh.triangle_alive(t)) continue;
    const Triangle corners = submesh.mesh.triangle(t);
    fresh.push_back({index_in_mesh[corners[0]], index_in_mesh[corners[1]], index_in_mesh[corners[2]]});
  }
  mesh.replace(submesh.triangles, fresh);
}

}  // namespace isobench::particles
