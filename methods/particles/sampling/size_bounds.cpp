#include "isobench/methods/particles/sampling/size_bounds.h"

#include <algorithm>
#include <limits>

namespace isobench::particles {

namespace {

using Eigen::Vector3d;

constexpr double scales_reached = 4.0;
constexpr double narrowest_brick = 4.0;  // voxels
constexpr double infinite = std::numeric_limits<double>::infinity();

double reach_of(const SizeBound& bound) { return bound.plateau + scales_reached * bound.scale; }

}  // namespace

SizeBounds::SizeBounds(const Isosurface& surface, double delta)
    : delta_(delta), voxel_(surface.voxel()), extent_(surface.extent()) {}

std::size_t SizeBounds::Grid::brick_of(const Vector3d& x) const {
  const Eigen::Array3i at = (x.array() / brick).cast<int>().max(0).min(bricks - 1);
  return static_cast<std::size_t>((static_cast<std::ptrdiff_t>(at[2]) * bricks[1] + at[1]) * bricks[0] + at[0]);
}

void SizeBounds::Grid::add(std::uint32_t bound, const Vector3d& position, const Vector3d& extent) {
  // A brick is as wide as the reach or wider, so the bound reaches only into its own brick and the 26 around it.
  std::vector<std::size_t> met;
  for (int corner = 0; corner < 27; ++corner) {
    const Eigen::Vector3i offset(corner % 3 - 1, corner / 3 % 3 - 1, corner / 9 - 1);
    const Vector3d x = (position + brick * offset.cast<double>()).cwiseMax(0.0).cwiseMin(extent);
    met.push_back(brick_of(x));
  }
  std::sort(met.begin(), met.end());
  met.erase(std::unique(met.begin(), met.end()), met.end());
  for (const std::size_t at : met) {
    if (list_of_brick[at] < 0) {
      list_of_brick[at] = static_cast<std::int32_t>(lists.size());
      lists.emplace_back();
    }
    lists[static_cast<std::size_t>(list_of_brick[at])].push_back(bound);
  }
}

SizeBounds::Grid& SizeBounds::grid_for(double reach) {
  double brick = narrowest_brick * voxel_;
  while (brick < reach) brick *= 2.0;
  for (Grid& grid : grids_) {
    if (grid.brick == brick) return grid;
  }
  Grid grid;
  grid.brick = brick;
  grid.bricks = (extent_.array() / brick).floor().cast<int>() + 1;
  grid.list_of_brick.assign(static_cast<std::size_t>(grid.bricks.cast<std::ptrdiff_t>().prod()), -1);
  return grids_.emplace_back(std::move(grid));
}

void SizeBounds::add(const std::vector<SizeBound>& bounds) {
  for (const SizeBound& bound : bounds) {
    grid_for(reach_of(bound)).add(static_cast<std::uint32_t>(bounds_.size()), bound.position, extent_);
    bounds_.push_back(bound);
  }
}

template <class Visit>
void SizeBounds::visit_near(const Vector3d& x, Visit&& visit) const {
  for (const Grid& grid : grids_) {
    const std::int32_t list = grid.list_of_brick[grid.brick_of(x)];
    if (list < 0) continue;
    for (const std::uint32_t n : grid.lists[static_cast<std::size_t>(list)]) {
      const double away = (x - bounds_[n].position).norm();
      if (away <= reach_of(bounds_[n])) visit(n, away);
    }
  }
}

double SizeBounds::bound(const Vector3d& x) const {
  double least = infinite;
  visit_near(x, [&](std::uint32_t n, double away) {
    const SizeBound& bound = bounds_[n];
    const double out = std::max(0.0, away - bound.plateau);
    const double beyond = std::max(0.0, out / bound.scale - 1.0);
    least = std::min(least, bound.h + delta_ * out + 0.125 * beyond * beyond * bound.scale);
  });
  return least;
}

double SizeBounds::scaled_distance(const Vector3d& x, std::size_t first) const {
  double least = infinite;
  visit_near(x, [&](std::uint32_t n, double away) {
    if (n >= first) least = std::min(least, away / bounds_[n].scale);
  });
  return least;
}

}  // namespace isobench::particles
