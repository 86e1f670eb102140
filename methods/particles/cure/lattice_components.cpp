#include "isobench/methods/particles/cure/lattice_components.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <map>

namespace isobench::particles {

namespace {

// Up to 16 of the points; each is as far as possible from those before it. 16 points enclose a small body.
std::vector<Eigen::Vector3d> spread(const std::vector<Eigen::Vector3d>& points) {
  constexpr std::size_t most = 16;
  std::vector<Eigen::Vector3d> chosen = {points.front()};
  std::vector<double> distance(points.size(), std::numeric_limits<double>::infinity());
  while (chosen.size() < std::min(most, points.size())) {
    for (std::size_t n = 0; n < points.size(); ++n)
      distance[n] = std::min(distance[n], (points[n] - chosen.back()).norm());
    const auto farthest = std::max_element(distance.begin(), distance.end());
    if (*farthest <= 0.0) break;
    chosen.push_back(points[static_cast<std::size_t>(farthest - distance.begin())]);
  }
  return chosen;
}

}  // namespace

LatticeComponents::LatticeComponents(const TriangleMesh& mesh) : mesh_(mesh), of_vertex_(component_roots(mesh)) {
  const auto differs = [this](std::uint32_t root) { return root != of_vertex_.front(); };
  if (std::any_of(of_vertex_.begin(), of_vertex_.end(), differs)) tree_.emplace(mesh.vertices);
}

std::vector<std::uint32_t> LatticeComponents::components_of(const std::vector<Eigen::Vector3d>& points) const {
  if (!tree_) return std::vector<std::uint32_t>(points.size(), of_vertex_.empty() ? 0 : of_vertex_.front());
  std::vector<std::uint32_t> result(points.size());
  tbb::parallel_for(std::size_t{0}, points.size(),
                    [&](std::size_t n) { result[n] = of_vertex_[tree_->nearest(points[n]).first]; });
  return result;
}

std::vector<std::vector<Eigen::Vector3d>> LatticeComponents::missing(const std::vector<std::uint32_t>& of_points,
                                                                     const std::vector<char>& counted) const {
  std::vector<char> has_point(of_vertex_.size(), 0);
  for (std::size_t n = 0; n < of_points.size(); ++n) {
    if (counted[n] != 0) has_point[of_points[n]] = 1;
  }
  std::map<std::uint32_t, std::vector<Eigen::Vector3d>> members;
  for (std::size_t n = 0; n < of_vertex_.size(); ++n) {
    if (has_point[of_vertex_[n]] == 0) members[of_vertex_[n]].push_back(mesh_.vertices[n]);
  }
  std::vector<std::vector<Eigen::Vector3d>> result;
  for (const auto& [component, vertices] : members) result.push_back(spread(vertices));
  return result;
}

}  // namespace isobench::particles
