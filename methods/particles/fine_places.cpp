#include "methods/particles/fine_places.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "methods/particles/random.h"
#include "methods/particles/seeds.h"

namespace isobench::particles {

namespace {

using Eigen::Vector3d;

constexpr double farthest_reach = 4.0;  // voxels: how far a place reaches

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

FinePlaces::FinePlaces(const Isosurface& surface, std::vector<CriticalPoint> points, double epsilon, double delta,
                       double least)
    : points_(std::move(points)),
      epsilon_(epsilon),
      delta_(delta),
      least_(least),
      voxel_(surface.voxel()),
      brick_(farthest_reach * surface.voxel()) {
  bricks_ = (surface.extent().array() / brick_).floor().cast<int>() + 1;
  list_of_brick_.assign(static_cast<std::size_t>(bricks_.prod()), -1);
  const Vector3d reach = Vector3d::Constant(brick_);
  for (std::uint32_t n = 0; n < points_.size(); ++n) {
    std::vector<std::size_t> met;
    for (int corner = 0; corner < 27; ++corner) {
      const Eigen::Vector3i way(corner % 3 - 1, corner / 3 % 3 - 1, corner / 9 - 1);
      const Vector3d x =
          (points_[n].position + way.cast<double>().cwiseProduct(reach)).cwiseMax(0.0).cwiseMin(surface.extent());
      met.push_back(brick_of(x));
    }
    std::sort(met.begin(), met.end());
    met.erase(std::unique(met.begin(), met.end()), met.end());
    for (const std::size_t brick : met) {
      if (list_of_brick_[brick] < 0) {
        list_of_brick_[brick] = static_cast<std::int32_t>(lists_.size());
        lists_.emplace_back();
      }
      lists_[static_cast<std::size_t>(list_of_brick_[brick])].push_back(n);
    }
  }
}

std::size_t FinePlaces::brick_of(const Vector3d& x) const {
  const Eigen::Array3i at = (x.array() / brick_).cast<int>().max(0).min(bricks_ - 1);
  return static_cast<std::size_t>((static_cast<std::ptrdiff_t>(at[2]) * bricks_[1] + at[1]) * bricks_[0] + at[0]);
}

double FinePlaces::edge_at(std::size_t point) const {
  return std::max(least_, 2.0 * epsilon_ * points_[point].distance);
}

double FinePlaces::bound(const Vector3d& x) const {
  double bound = std::numeric_limits<double>::infinity();
  const std::int32_t list = list_of_brick_[brick_of(x)];
  if (list < 0) return bound;
  for (const std::uint32_t n : lists_[static_cast<std::size_t>(list)]) {
    const double away = (x - points_[n].position).norm();
    if (away > farthest_reach * voxel_) continue;
    const double beyond = std::max(0.0, away / voxel_ - 1.0);
    bound = std::min(bound, edge_at(n) + delta_ * away + 0.125 * beyond * beyond * voxel_);
  }
  return bound;
}

void add_seeds_at(const FinePlaces& places, const Isosurface& surface, const Spacing& spacing, std::uint64_t seed,
                  std::vector<Vector3d>& seeds) {
  const double reach = 0.5 * farthest_reach * surface.voxel();
  std::vector<std::vector<Candidate>> candidates(places.points().size());
  tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t n) {
    const CriticalPoint& point = places.points()[n];
    candidates[n] = candidates_around(point.position, std::max(0.5 * places.edge_at(n), point.distance), reach, surface,
                                      spacing, seed, n);
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
      if ((other.point - places.points()[n].position).norm() < 2.0 * reach) near.push_back(other);
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
