#include "isobench/methods/sizing/medial_axis/axis_ends.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>

#include "isobench/methods/sizing/medial_axis/point_tree.h"

namespace isobench {

namespace {

/// The radius of the osculating ball of sample n on the side of `direction`, if the ball is empty; else 0.
double empty_radius(const SurfaceSamples& samples, const PointTree& tree, std::size_t n,
                    const Eigen::Vector3d& direction, double bend, double cap) {
  constexpr double tolerance = 1e-6;  // the same as for shrinking balls
  if (!(bend > 1.0 / cap)) return 0.0;
  const double radius = 1.0 / bend;
  const Eigen::Vector3d centre = samples.points[n] + radius * direction;
  return tree.nearest(centre, n).second >= radius * (1.0 - tolerance) ? radius : 0.0;
}

}  // namespace

MedialBalls axis_ends(const SurfaceSamples& samples, double cap, Monitor& monitor) {
  MedialBalls ends;
  if (samples.points.empty()) return ends;
  const PointTree tree(samples.points);
  std::vector<std::array<double, 2>> radii(samples.points.size());
  monitor.check();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, radii.size(), 256), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      const Eigen::Vector3d& normal = samples.normals[n];
      // Inside, a ball touches where the surface is convex (κ1 > 0); outside, where it is concave (κ2 < 0).
      radii[n] = {empty_radius(samples, tree, n, -normal, samples.curvature[n].k1, cap),
                  empty_radius(samples, tree, n, normal, -samples.curvature[n].k2, cap)};
    }
  });
  for (std::size_t n = 0; n < radii.size(); ++n) {
    for (const auto& [radius, side] : {std::pair{radii[n][0], -1.0}, std::pair{radii[n][1], 1.0}}) {
      if (radius == 0.0) continue;
      ends.centres.push_back(samples.points[n] + side * radius * samples.normals[n]);
      ends.radii.push_back(radius);
    }
  }
  return ends;
}

}  // namespace isobench
