#include "isobench/methods/particles/finish/changes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace isobench::particles {

namespace {

double longest_edge(const TriangleMesh& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const auto length = [&](std::uint32_t u, std::uint32_t v) { return (mesh.vertices[u] - mesh.vertices[v]).norm(); };
  return std::max({length(a, b), length(b, c), length(c, a)});
}

}  // namespace

std::vector<EditableMesh::Index> moved_vertices(const EditableMesh& before, const EditableMesh& after) {
  std::vector<EditableMesh::Index> moved;
  for (EditableMesh::Index v = 0; v < after.vertex_count(); ++v) {
    if (!after.alive(v)) continue;
    if (v >= before.vertex_count() || after.points[v] != before.points[v]) moved.push_back(v);
  }
  return moved;
}

std::vector<std::uint8_t> changed_triangles(const EditableMesh& before, const EditableMesh& after) {
  std::vector<std::uint8_t> moved(after.vertex_count(), 0);
  for (const EditableMesh::Index v : moved_vertices(before, after)) moved[v] = 1;
  std::vector<std::uint8_t> changed;
  for (EditableMesh::Index t = 0; 3 * t < after.half_edge_count(); ++t) {
    if (!after.triangle_alive(t)) continue;
    const Triangle corners = after.triangle(t);
    const bool is_new = 3 * t >= before.half_edge_count() || before.triangle(t) != corners;
    const bool has_moved = std::any_of(corners.begin(), corners.end(), [&](std::uint32_t c) { return moved[c] != 0; });
    changed.push_back(is_new || has_moved ? 1 : 0);
  }
  return changed;
}

std::set<std::uint32_t> points_near(const std::vector<Eigen::Vector3d>& points, const TriangleMesh& mesh,
                                    const std::vector<std::array<std::uint32_t, 2>>& intersections, int doublings) {
  std::set<std::uint32_t> triangles;
  for (const auto& pair : intersections) triangles.insert(pair.begin(), pair.end());
  std::set<std::uint32_t> near;
  for (const std::uint32_t triangle : triangles) {
    Eigen::AlignedBox3d box;
    for (const std::uint32_t corner : mesh.triangles[triangle]) box.extend(mesh.vertices[corner]);
    const double reach = std::exp2(doublings) * longest_edge(mesh, triangle);
    for (std::uint32_t v = 0; v < points.size(); ++v) {
      if (box.squaredExteriorDistance(points[v]) <= reach * reach) near.insert(v);
    }
  }
  return near;
}

}  // namespace isobench::particles
