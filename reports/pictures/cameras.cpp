#include "isobench/reports/pictures/cameras.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace isobench {

namespace {

const Eigen::Vector3d from_a_corner(0.6, -0.7, 0.4);
constexpr double width_over_height = 0.83 * 640.0 / 520.0;  // the colour bar takes part of the width

Eigen::Vector3d scaled_normal(const TriangleMesh& mesh, const Triangle& t) {
  return (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
}

}  // namespace

double mean_edge(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) sum += (mesh.vertices[t[i]] - mesh.vertices[t[(i + 1) % 3]]).norm();
  }
  return sum / static_cast<double>(3 * mesh.triangles.size());
}

View view_of_all(const std::vector<const TriangleMesh*>& meshes) {
  Eigen::AlignedBox3d box;
  for (const TriangleMesh* mesh : meshes) {
    for (const Eigen::Vector3d& vertex : mesh->vertices) box.extend(vertex);
  }
  View view;
  view.focus = box.center();
  view.towards = from_a_corner;
  // The picture must show all corners of the box.
  const Eigen::Vector3d direction = from_a_corner.normalized();
  const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(direction).normalized();
  const Eigen::Vector3d up = direction.cross(right);
  double across = 0.0;
  double along = 0.0;
  for (int n = 0; n < 8; ++n) {
    const Eigen::Vector3d corner = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(n)) - view.focus;
    across = std::max(across, std::abs(corner.dot(right)));
    along = std::max(along, std::abs(corner.dot(up)));
  }
  view.half_height = 1.05 * std::max(along, across / width_over_height);
  view.eye_distance = 2.0 * box.diagonal().norm();
  return view;
}

View closer_view(const View& whole, const TriangleMesh& mesh, double edge_length) {
  const Eigen::Vector3d direction = whole.towards.normalized();
  View view = whole;
  double nearest = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    const double depth = (vertex - whole.focus).dot(direction);
    if (depth <= nearest) continue;
    nearest = depth;
    view.focus = vertex;
  }
  view.half_height = std::min(whole.half_height, 12.0 * edge_length);
  return view;
}

View view_of_triangle(const TriangleMesh& mesh, std::size_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  View view;
  double longest = 0.0;
  view.focus = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
  for (std::size_t i = 0; i < 3; ++i) {
    longest = std::max(longest, (mesh.vertices[t[i]] - mesh.vertices[t[(i + 1) % 3]]).norm());
  }
  // The neighbours' normals are used, too, because a triangle without area has none.
  view.towards = Eigen::Vector3d::Zero();
  for (const Triangle& other : mesh.triangles) {
    const bool touches =
        std::any_of(other.begin(), other.end(), [&t](std::uint32_t v) { return v == t[0] || v == t[1] || v == t[2]; });
    if (touches) view.towards += scaled_normal(mesh, other);
  }
  if (view.towards.norm() == 0.0) view.towards = from_a_corner;
  view.half_height = 2.0 * std::max(longest, 1e-9);
  view.eye_distance = 0.5 * view.half_height;  // triangles that fold over this one must be behind the eye
  return view;
}

View view_of_place(const TriangleMesh& mesh, const Eigen::Vector3d& place, double edge_length) {
  const auto nearest = std::min_element(
      mesh.vertices.begin(), mesh.vertices.end(),
      [&place](const auto& a, const auto& b) { return (a - place).squaredNorm() < (b - place).squaredNorm(); });
  View view;
  view.focus = *nearest;
  view.half_height = 4.0 * edge_length;
  view.towards = Eigen::Vector3d::Zero();
  // Of the triangles around it, not only of those that touch it: these may be slivers.
  for (const Triangle& t : mesh.triangles) {
    if ((mesh.vertices[t[0]] - view.focus).norm() < 2.0 * edge_length) view.towards += scaled_normal(mesh, t);
  }
  if (view.towards.norm() == 0.0) view.towards = from_a_corner;
  view.eye_distance = view.half_height;
  return view;
}

}  // namespace isobench
