#include "isobench/methods/particles/cure/lost_components.h"

#include <algorithm>
#include <limits>

#include "isobench/methods/particles/sampling/component_seeds.h"

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

std::vector<std::vector<Eigen::Vector3d>> lost_components(const Isosurface& surface, const CertifiedTopology& topology,
                                                          const std::vector<std::uint32_t>& of_points,
                                                          const std::vector<char>& counted) {
  std::vector<char> lost;
  for (const SurfaceComponent& component : topology.components) lost.push_back(component.is_left_out ? 0 : 1);
  for (std::size_t n = 0; n < of_points.size(); ++n) {
    if (counted[n] != 0) lost[of_points[n]] = 0;
  }
  if (std::all_of(lost.begin(), lost.end(), [](char is_lost) { return is_lost == 0; })) return {};
  std::vector<std::vector<Eigen::Vector3d>> result;
  for (const std::vector<Eigen::Vector3d>& points : points_on_components(surface, topology, lost)) {
    if (!points.empty()) result.push_back(spread(points));
  }
  return result;
}

}  // namespace isobench::particles
