#include "isobench/methods/advancing-front/seeds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "isobench/foundation/random.h"
#include "isobench/methods/advancing-front/fences.h"
#include "isobench/methods/sizing/medial_axis/point_tree.h"

namespace isobench::advancing_front {

std::vector<Component> components_of(const TriangleMesh& mesh) {
  const std::vector<std::uint32_t> roots = component_roots(mesh);
  std::vector<std::size_t> number(roots.size());
  std::vector<Component> components;
  for (std::uint32_t n = 0; n < roots.size(); ++n) {
    if (roots[n] == n) {
      number[n] = components.size();
      components.emplace_back();
    }
    components[number[roots[n]]].vertices.push_back(n);
  }
  for (Component& component : components) {
    for (const std::uint32_t n : component.vertices) component.box.extend(mesh.vertices[n]);
  }
  std::stable_sort(components.begin(), components.end(),
                   [](const Component& a, const Component& b) { return a.vertices.size() > b.vertices.size(); });
  return components;
}

std::vector<Component> components_without(const Isosurface& surface, const TriangleMesh& mesh,
                                          const std::vector<Component>& components,
                                          const std::vector<Vertex>& vertices) {
  std::vector<std::size_t> number(mesh.vertices.size());
  for (std::size_t c = 0; c < components.size(); ++c) {
    for (const std::uint32_t n : components[c].vertices) number[n] = c;
  }
  const PointTree tree(mesh.vertices);
  std::vector<char> met(components.size(), 0);
  for (const Vertex& vertex : vertices) {
    const std::size_t nearest = tree.nearest(vertex.x).first;
    const Eigen::Vector3d normal = outward_normal(surface.value_gradient(mesh.vertices[nearest]).gradient);
    if (normal.dot(vertex.normal) > 0.0) met[number[nearest]] = 1;
  }
  std::vector<Component> bare;
  for (std::size_t c = 0; c < components.size(); ++c) {
    if (met[c] == 0) bare.push_back(components[c]);
  }
  return bare;
}

std::vector<Eigen::Vector3d> starting_points(const TriangleMesh& mesh, const Component& component, const Step& step,
                                             std::uint64_t seed) {
  constexpr std::size_t draws = 32;
  std::vector<std::pair<double, std::uint32_t>> drawn;
  for (std::size_t n = 0; n < draws; ++n) {
    const double at = uniform_random(seed, component.vertices.front(), n);
    const std::uint32_t vertex =
        component.vertices[static_cast<std::size_t>(at * static_cast<double>(component.vertices.size()))];
    drawn.emplace_back(-step(mesh.vertices[vertex]), vertex);
  }
  std::sort(drawn.begin(), drawn.end());
  drawn.erase(std::unique(drawn.begin(), drawn.end()), drawn.end());
  std::vector<Eigen::Vector3d> points;
  for (const auto& [key, vertex] : drawn) points.push_back(mesh.vertices[vertex]);
  return points;
}

std::optional<std::array<Vertex, 3>> seed_triangle(const Isosurface& surface, const Step& step,
                                                   const Eigen::Vector3d& near, std::uint64_t seed) {
  const auto foot = surface.project(near);
  if (!foot) return std::nullopt;
  const Vertex centre = make_vertex(surface, step, *foot);
  const Eigen::Vector3d right = centre.normal.unitOrthogonal(), up = centre.normal.cross(right);
  const double turn = 2.0 * std::numbers::pi * uniform_random(seed, 0, 7);
  std::array<Vertex, 3> corners;
  for (std::size_t n = 0; n < 3; ++n) {
    const double angle = turn + static_cast<double>(n) * 2.0 * std::numbers::pi / 3.0;
    const auto corner =
        surface.project(*foot + centre.step / std::numbers::sqrt3 * (std::cos(angle) * right + std::sin(angle) * up));
    if (!corner) return std::nullopt;
    corners[n] = make_vertex(surface, step, *corner);
  }
  const Tentative t{{corners.data(), &corners[1], &corners[2]}};
  if (normal_agreement(t) < 0.5 || circumradius_over_inradius(t) > 4.0) return std::nullopt;
  return corners;
}

}  // namespace isobench::advancing_front
