#include "isobench/methods/particles/sampling/critical_seeds.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "isobench/foundation/random.h"

namespace isobench::particles {

namespace {

using Eigen::Vector3d;

/// A point on the surface that may become a seed.
struct Candidate {
  Vector3d point;
  Vector3d normal;
  double spacing = 0.0;
};

Candidate candidate_at(const Vector3d& x, const SizedSurface& sized) {
  return {x, outward_normal(sized.surface().value_gradient(x).gradient), sized.spacing(x)};
}

/// Random points on spheres of growing radius around `centre`, projected to the surface. `index` numbers the centre.
std::vector<Candidate> candidates_around(const Vector3d& centre, double first_radius, double last_radius,
                                         const SizedSurface& sized, std::uint64_t seed, std::uint64_t index) {
  constexpr double growth = 1.25;
  constexpr std::uint64_t points_per_sphere = 60;
  std::vector<Candidate> found;
  std::uint64_t drawn = 0;
  for (double radius = first_radius; radius < last_radius; radius *= growth) {
    for (std::uint64_t n = 0; n < points_per_sphere; ++n, ++drawn) {
      const std::uint64_t stream = 8 * drawn;
      const double z = 2.0 * uniform_random(seed, index, stream) - 1.0;
      const double angle = 2.0 * std::numbers::pi * uniform_random(seed, index, stream + 1);
      const double r = std::sqrt(1.0 - z * z);
      const auto foot =
          sized.surface().project(centre + radius * Vector3d(r * std::cos(angle), r * std::sin(angle), z));
      if (foot && (*foot - centre).norm() <= last_radius) found.push_back(candidate_at(*foot, sized));
    }
  }
  return found;
}

bool has_room(const Candidate& candidate, const std::vector<Candidate>& others) {
  constexpr double share_of_spacing = 0.75;
  return std::none_of(others.begin(), others.end(), [&](const Candidate& other) {
    const double reach = share_of_spacing * std::min(candidate.spacing, other.spacing);
    return (candidate.point - other.point).squaredNorm() < reach * reach && candidate.normal.dot(other.normal) > 0.0;
  });
}

}  // namespace

std::vector<SizeBound> critical_bounds(const std::vector<CriticalPoint>& points, double epsilon, double floor,
                                       double voxel) {
  std::vector<SizeBound> bounds;
  bounds.reserve(points.size());
  for (const CriticalPoint& point : points) {
    bounds.push_back({point.position, std::max(floor, 2.0 * epsilon * point.distance), 0.0, voxel});
  }
  return bounds;
}

void add_critical_seeds(const std::vector<CriticalPoint>& points, const SizedSurface& sized, std::uint64_t seed,
                        std::vector<Vector3d>& seeds) {
  constexpr double seeded_voxels = 2.0;  // around a point
  const double reach = seeded_voxels * sized.surface().voxel();
  std::vector<std::vector<Candidate>> candidates(points.size());
  tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t n) {
    const double first_radius = std::max(0.5 * sized.bounds().at(n).h, points[n].distance);
    candidates[n] = candidates_around(points[n].position, first_radius, reach, sized, seed, n);
  });
  // The seeds so far that may be close to a candidate.
  std::vector<Candidate> placed;
  for (const Vector3d& x : seeds) {
    if (sized.bounds().bound(x) < std::numeric_limits<double>::infinity()) placed.push_back(candidate_at(x, sized));
  }
  for (std::size_t n = 0; n < candidates.size(); ++n) {
    std::vector<Candidate> near;
    for (const Candidate& other : placed) {
      if ((other.point - points[n].position).norm() < 2.0 * reach) near.push_back(other);
    }
    for (const Candidate& candidate : candidates[n]) {
      if (!has_room(candidate, near)) continue;
      near.push_back(candidate);
      placed.push_back(candidate);
      seeds.push_back(candidate.point);
    }
  }
}

}  // namespace isobench::particles
