#include "isobench/methods/delaunay-refinement/seeds.h"

#include <algorithm>
#include <limits>
#include <map>

#include "isobench/foundation/random.h"

namespace isobench::delaunay_refinement {

namespace {

constexpr std::size_t fewest = 8;
constexpr std::size_t most = 200;

std::vector<Eigen::Vector3d> spread(const std::vector<Eigen::Vector3d>& points, double spacing, std::uint64_t seed) {
  std::vector<Eigen::Vector3d> chosen = {points[split_mix_64(seed) % points.size()]};
  std::vector<double> distance(points.size(), std::numeric_limits<double>::infinity());
  while (chosen.size() < most) {
    std::size_t farthest = 0;
    for (std::size_t n = 0; n < points.size(); ++n) {
      distance[n] = std::min(distance[n], (points[n] - chosen.back()).norm());
      if (distance[n] > distance[farthest]) farthest = n;
    }
    if (distance[farthest] <= (chosen.size() < fewest ? 0.0 : spacing)) break;
    chosen.push_back(points[farthest]);
  }
  return chosen;
}

}  // namespace

std::vector<Eigen::Vector3d> seeds_on(const TriangleMesh& mesh, double spacing, std::uint64_t seed) {
  const std::vector<std::uint32_t> roots = component_roots(mesh);
  std::map<std::uint32_t, std::vector<Eigen::Vector3d>> components;
  for (std::size_t n = 0; n < roots.size(); ++n) components[roots[n]].push_back(mesh.vertices[n]);
  std::vector<Eigen::Vector3d> seeds;
  for (const auto& [root, points] : components) {
    const std::vector<Eigen::Vector3d> some = spread(points, spacing, seed ^ root);
    seeds.insert(seeds.end(), some.begin(), some.end());
  }
  return seeds;
}

}  // namespace isobench::delaunay_refinement
