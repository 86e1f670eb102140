#include "isobench/methods/particles/sampling/critical_seeds.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "isobench/methods/particles/sampling/random.h"
#include "isobench/methods/particles/sampling/seeds.h"

namespace isobench::particles {

namespace {

using Eigen::Vector3d;

struct Candidate {
  Vector3d point;
  Vector3d normal;
  double spacing = 0.0;
};

/// In rings of growing radius around a point, at random, projected to the surface.
std::vector<Candidate> candidates_around(const Vector3d& centre, double first, double last, const Isosurface& surface,
                                         const Spacing& spacing, std::uint64_t seed, std::uint64_t place) {
  constexpr double growth = 1.25;
  constexpr std::uint64_t each = 60;
  std::vector<Candidate> found;
  std::uint64_t drawn = 0;
  for (double radius = first; radius < last; radius *= growth) {
    for (std::uint64_t n = 0; n < each; ++n, ++drawn) {
      const std::uint64_t stream = 8 * drawn;
      const double z = 2.0 * uniform(seed, place, stream) - 1.0;
      const double angle = 2.0 * std::numbers::pi * uniform(seed, place, stream + 1);
      const double flat = std::sqrt(1.0 - z * z);
      const auto foot = surface.project(centre + radius * Vector3d(flat * std::cos(angle), flat * std::sin(angle), z));
      if (!foot || (*foot - centre).norm() > last) continue;
      found.push_back({*foot, outward_normal(surface.value_gradient(*foot).gradient), spacing(*foot)});
    }
  }
  return found;
}

bool has_room(const Candidate& candidate, const std::vector<Candidate>& others) {
  constexpr double apart = 0.75;
  return std::none_of(others.begin(), others.end(), [&](const Candidate& other) {
    const double reach = apart * std::min(candidate.spacing, other.spacing);
    return (candidate.point - other.point).squaredNorm() < reach * reach && candidate.normal.dot(other.normal) > 0.0;
  });
}

}  // namespace

std::vector<SizeBound> critical_bounds(const std::vector<CriticalPoint>& points, double epsilon, double least,
                                       double voxel) {
  std::vector<SizeBound> places;
  places.reserve(points.size());
  for (const CriticalPoint& point : points) {
    places.push_back({point.position, std::max(least, 2.0 * epsilon * point.distance), 0.0, voxel});
  }
  return places;
}

void add_critical_seeds(const std::vector<CriticalPoint>& points, const SizeBounds& places, const Isosurface& surface,
                        const Spacing& spacing, std::uint64_t seed, std::vector<Vector3d>& seeds) {
  constexpr double seeded = 2.0;  // voxels around a point
  const double reach = seeded * surface.voxel();
  std::vector<std::vector<Candidate>> candidates(points.size());
  tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t n) {
    const double first = std::max(0.5 * places.at(n).edge, points[n].distance);
    candidates[n] = candidates_around(points[n].position, first, reach, surface, spacing, seed, n);
  });
  // Those there already that a candidate may meet.
  std::vector<Candidate> there;
  for (const Vector3d& x : seeds) {
    if (places.bound(x) == std::numeric_limits<double>::infinity()) continue;
    there.push_back({x, outward_normal(surface.value_gradient(x).gradient), spacing(x)});
  }
  for (std::size_t n = 0; n < candidates.size(); ++n) {
    std::vector<Candidate> near;
    for (const Candidate& other : there) {
      if ((other.point - points[n].position).norm() < 2.0 * reach) near.push_back(other);
    }
    for (const Candidate& candidate : candidates[n]) {
      if (!has_room(candidate, near)) continue;
      near.push_back(candidate);
      there.push_back(candidate);
      seeds.push_back(candidate.point);
    }
  }
}

}  // namespace isobench::particles
