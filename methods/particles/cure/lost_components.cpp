#include "isobench/methods/particles/cure/lost_components.h"

#include <algorithm>
#include <limits>

#include "isobench/methods/particles/sampling/component_seeds.h"

namespace isobench::particles {

namespace {

// Up to 16 of the points; each is as far as possible from those before it. 16 points enclose a small body.
std::vector<Eigen::Vector3d> spread(const std::vector<Eigen::Vector3d>& points) {
  constexpr std::size_t most = 16;
  if (points.empty()) return {};
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

LostComponents::LostComponents(const Isosurface& surface, const CertifiedTopology& topology)
    : surface_(surface), topology_(topology), points_(topology.components.size()) {}

std::vector<std::vector<Eigen::Vector3d>> LostComponents::find(const std::vector<std::uint32_t>& of_points,
                                                               const std::vector<char>& counted) {
  std::vector<char> lost;
  for (const SurfaceComponent& component : topology_.components) lost.push_back(component.is_left_out ? 0 : 1);
  for (std::size_t n = 0; n < of_points.size(); ++n) {
    if (counted[n] != 0) lost[of_points[n]] = 0;
  }
  remember(lost);
  std::vector<std::vector<Eigen::Vector3d>> result;
  for (std::size_t c = 0; c < lost.size(); ++c) {
    if (lost[c] != 0 && !points_[c]->empty()) result.push_back(*points_[c]);
  }
  return result;
}

void LostComponents::remember(const std::vector<char>& lost) {
  std::vector<char> is_new(lost.size(), 0);
  for (std::size_t c = 0; c < lost.size(); ++c) is_new[c] = lost[c] != 0 && !points_[c] ? 1 : 0;
  if (std::find(is_new.begin(), is_new.end(), 1) == is_new.end()) return;
  const std::vector<std::vector<Eigen::Vector3d>> all = points_on_components(surface_, topology_, is_new);
  auto found = all.begin();
  for (std::size_t c = 0; c < lost.size(); ++c) {
    if (is_new[c] != 0) points_[c] = spread(*found++);
  }
}

}  // namespace isobench::particles
