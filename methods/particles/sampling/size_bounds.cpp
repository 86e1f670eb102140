#include "isobench/methods/particles/sampling/size_bounds.h"

#include <algorithm>
#include <limits>

namespace isobench::particles {

namespace {

using Eigen::Vector3d;

constexpr double units_reached = 4.0;
constexpr double least_brick = 4.0;  // voxels
constexpr double infinite = std::numeric_limits<double>::infinity();

double reach_of(const SizeBound& place) { return place.flat + units_reached * place.unit; }

}  // namespace

SizeBounds::SizeBounds(const Isosurface& surface, double delta)
    : delta_(delta), voxel_(surface.voxel()), extent_(surface.extent()) {}

std::size_t SizeBounds::Level::brick_of(const Vector3d& x) const {
  const Eigen::Array3i at = (x.array() / brick).cast<int>().max(0).min(bricks - 1);
  return static_cast<std::size_t>((static_cast<std::ptrdiff_t>(at[2]) * bricks[1] + at[1]) * bricks[0] + at[0]);
}

void SizeBounds::Level::add(std::uint32_t place, const Vector3d& position, const Vector3d& extent) {
  std::vector<std::size_t> met;
  for (int corner = 0; corner < 27; ++corner) {
    const Eigen::Vector3i way(corner % 3 - 1, corner / 3 % 3 - 1, corner / 9 - 1);
    const Vector3d x = (position + brick * way.cast<double>()).cwiseMax(0.0).cwiseMin(extent);
    met.push_back(brick_of(x));
  }
  std::sort(met.begin(), met.end());
  met.erase(std::unique(met.begin(), met.end()), met.end());
  for (const std::size_t at : met) {
    if (list_of_brick[at] < 0) {
      list_of_brick[at] = static_cast<std::int32_t>(lists.size());
      lists.emplace_back();
    }
    lists[static_cast<std::size_t>(list_of_brick[at])].push_back(place);
  }
}

SizeBounds::Level& SizeBounds::level_for(double reach) {
  double brick = least_brick * voxel_;
  while (brick < reach) brick *= 2.0;
  for (Level& level : levels_) {
    if (level.brick == brick) return level;
  }
  Level level;
  level.brick = brick;
  level.bricks = (extent_.array() / brick).floor().cast<int>() + 1;
  level.list_of_brick.assign(static_cast<std::size_t>(level.bricks.cast<std::ptrdiff_t>().prod()), -1);
  return levels_.emplace_back(std::move(level));
}

void SizeBounds::add(const std::vector<SizeBound>& places) {
  for (const SizeBound& place : places) {
    level_for(reach_of(place)).add(static_cast<std::uint32_t>(places_.size()), place.position, extent_);
    places_.push_back(place);
  }
}

template <class Visit>
void SizeBounds::visit_near(const Vector3d& x, Visit&& visit) const {
  for (const Level& level : levels_) {
    const std::int32_t list = level.list_of_brick[level.brick_of(x)];
    if (list < 0) continue;
    for (const std::uint32_t n : level.lists[static_cast<std::size_t>(list)]) {
      const double away = (x - places_[n].position).norm();
      if (away <= reach_of(places_[n])) visit(n, away);
    }
  }
}

double SizeBounds::bound(const Vector3d& x) const {
  double bound = infinite;
  visit_near(x, [&](std::uint32_t n, double away) {
    const SizeBound& place = places_[n];
    const double out = std::max(0.0, away - place.flat);
    const double beyond = std::max(0.0, out / place.unit - 1.0);
    bound = std::min(bound, place.edge + delta_ * out + 0.125 * beyond * beyond * place.unit);
  });
  return bound;
}

double SizeBounds::units_from(const Vector3d& x, std::size_t first) const {
  double least = infinite;
  visit_near(x, [&](std::uint32_t n, double away) {
    if (n >= first) least = std::min(least, away / places_[n].unit);
  });
  return least;
}

}  // namespace isobench::particles
