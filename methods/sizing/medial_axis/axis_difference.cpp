#include "isobench/methods/sizing/medial_axis/axis_difference.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "isobench/methods/sizing/medial_axis/point_tree.h"

namespace isobench {

namespace {

constexpr double thin_below = 2.0;    // voxels
constexpr double found_within = 1.0;  // voxels

double quantile(std::vector<double> values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

AxisDifference axis_difference(const SurfaceSamples& samples, const MedialBalls& feet, const MedialBalls& balls,
                               double voxel, double cap) {
  AxisDifference result;
  std::optional<PointTree> feet_tree;
  std::optional<PointTree> balls_tree;
  if (!feet.centres.empty()) feet_tree.emplace(feet.centres);
  if (!balls.centres.empty()) balls_tree.emplace(balls.centres);
  std::vector<double> relative;
  std::vector<double> absolute;
  std::array<double, 3> count{};
  std::array<double, 3> differing{};
  for (std::size_t n = 0; n < samples.points.size(); ++n) {
    const Eigen::Vector3d& x = samples.points[n];
    const double radius = 1.0 / samples.curvature[n].max_abs();
    const double to_feet = feet_tree ? std::min(cap, feet_tree->nearest(x).second) : cap;
    double to_balls = cap;
    AxisPlace place = AxisPlace::other;
    if (balls_tree) {
      const auto [ball, distance] = balls_tree->nearest(x);
      to_balls = std::min(cap, distance);
      const bool found = feet_tree && feet_tree->nearest(balls.centres[ball]).second <= found_within * voxel;
      if (!found) place = AxisPlace::missed;
    }
    if (to_balls < thin_below * voxel) place = AxisPlace::thin;
    result.by_feet.push_back(std::min(to_feet, radius));
    result.by_balls.push_back(std::min(to_balls, radius));
    result.place.push_back(place);
    relative.push_back(std::abs(result.by_feet.back() / result.by_balls.back() - 1.0));
    absolute.push_back(std::abs(result.by_feet.back() - result.by_balls.back()) / voxel);
    count[static_cast<std::size_t>(place)] += 1.0;
    if (absolute.back() > 1.0) differing[static_cast<std::size_t>(place)] += 1.0;
  }
  const double all = static_cast<double>(samples.points.size());
  const double apart = differing[0] + differing[1] + differing[2];
  for (std::size_t c = 0; c < count.size(); ++c) {
    result.share[c] = 100.0 * count[c] / all;
    result.share_of_differing[c] = apart > 0.0 ? 100.0 * differing[c] / apart : 0.0;
  }
  result.differing = 100.0 * apart / all;
  result.median = quantile(std::move(relative), 0.5);
  result.p95 = quantile(std::move(absolute), 0.95);
  return result;
}

}  // namespace isobench
