#include "isobench/methods/particles/sampling/size_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace isobench::particles {

namespace {

using Eigen::Vector3d;

constexpr double scales_reached = 4.0;
constexpr double block = 4.0;  // voxels
constexpr double infinite = std::numeric_limits<double>::infinity();

double reach_of(const SizeBound& bound) { return bound.plateau + scales_reached * bound.scale; }

Eigen::Array3i cell_of(const Vector3d& x, double width, const Eigen::Array3i& cells) {
  return (x.array() / width).cast<int>().max(0).min(cells - 1);
}

Eigen::Array3i cells_in(const Vector3d& extent, double width) {
  return (extent.array() / width).floor().cast<int>() + 1;
}

std::uint64_t number_of(const Eigen::Array3i& at, const Eigen::Array3i& cells) {
  const Eigen::Array<std::uint64_t, 3, 1> wide = at.cast<std::uint64_t>();
  return (wide[2] * static_cast<std::uint64_t>(cells[1]) + wide[1]) * static_cast<std::uint64_t>(cells[0]) + wide[0];
}

}  // namespace

SizeBounds::SizeBounds(const Isosurface& surface, double delta)
    : delta_(delta), voxel_(surface.voxel()), extent_(surface.extent()), blocks_(cells_in(extent_, block * voxel_)) {}

std::uint64_t SizeBounds::Grid::brick_of(const Vector3d& x) const {
  return number_of(cell_of(x, brick, bricks), bricks);
}

std::int32_t SizeBounds::Grid::list_at(const Vector3d& x) const {
  if (!is_narrow) return list_of_brick[brick_of(x)];
  const auto found = list_of_narrow_brick.find(brick_of(x));
  return found == list_of_narrow_brick.end() ? -1 : found->second;
}

SizeBounds::List& SizeBounds::Grid::list_for(std::uint64_t at) {
  std::int32_t& list = is_narrow ? list_of_narrow_brick.try_emplace(at, -1).first->second : list_of_brick[at];
  if (list < 0) {
    list = static_cast<std::int32_t>(lists.size());
    lists.emplace_back();
  }
  return lists[static_cast<std::size_t>(list)];
}

std::vector<std::uint64_t> SizeBounds::Grid::bricks_around(const Vector3d& position, const Vector3d& extent) const {
  // A brick is as wide as the reach or wider, so the bound reaches only into its own brick and the 26 around it.
  std::vector<std::uint64_t> met;
  for (int corner = 0; corner < 27; ++corner) {
    const Eigen::Vector3i offset(corner % 3 - 1, corner / 3 % 3 - 1, corner / 9 - 1);
    const Vector3d x = (position + brick * offset.cast<double>()).cwiseMax(0.0).cwiseMin(extent);
    met.push_back(brick_of(x));
  }
  std::sort(met.begin(), met.end());
  met.erase(std::unique(met.begin(), met.end()), met.end());
  return met;
}

SizeBounds::Grid& SizeBounds::grid_for(double reach) {
  // From a brick that holds the whole volume to one whose number still has 64 bits there are fewer grids than a mark
  // has bits.
  const double widest = extent_.maxCoeff();
  const double narrowest = widest * std::exp2(-20);
  double brick = block * voxel_;
  while (brick < std::min(reach, widest)) brick *= 2.0;
  while (0.5 * brick >= std::max(reach, narrowest)) brick *= 0.5;
  for (Grid& grid : grids_) {
    if (grid.brick == brick) return grid;
  }
  Grid grid;
  grid.brick = brick;
  grid.bricks = cells_in(extent_, brick);
  grid.is_narrow = brick < block * voxel_;
  if (!grid.is_narrow)
    grid.list_of_brick.assign(static_cast<std::size_t>(grid.bricks.cast<std::ptrdiff_t>().prod()), -1);
  return grids_.emplace_back(std::move(grid));
}

void SizeBounds::mark_blocks(const Vector3d& position, double reach, std::uint32_t mark) {
  const Eigen::Array3i first = cell_of(position - Vector3d::Constant(reach), block * voxel_, blocks_);
  const Eigen::Array3i last = cell_of(position + Vector3d::Constant(reach), block * voxel_, blocks_);
  Eigen::Array3i at;
  for (at[2] = first[2]; at[2] <= last[2]; ++at[2]) {
    for (at[1] = first[1]; at[1] <= last[1]; ++at[1]) {
      for (at[0] = first[0]; at[0] <= last[0]; ++at[0]) grids_at_block_[number_of(at, blocks_)] |= mark;
    }
  }
}

void SizeBounds::add(const std::vector<SizeBound>& bounds) {
  if (bounds.empty()) return;
  grids_at_block_.resize(static_cast<std::size_t>(blocks_.cast<std::ptrdiff_t>().prod()), 0U);
  // In the order of h, so that each list stays nearly in order.
  std::vector<std::uint32_t> added(bounds.size());
  std::iota(added.begin(), added.end(), static_cast<std::uint32_t>(bounds_.size()));
  bounds_.insert(bounds_.end(), bounds.begin(), bounds.end());
  std::stable_sort(added.begin(), added.end(),
                   [this](std::uint32_t a, std::uint32_t b) { return bounds_[a].h < bounds_[b].h; });
  const auto is_smaller = [](const Listed& a, const Listed& b) { return a.h < b.h; };
  for (const std::uint32_t n : added) {
    const SizeBound& bound = bounds_[n];
    Grid& grid = grid_for(reach_of(bound));
    const Listed listed = {bound.position, bound.h, bound.plateau, reach_of(bound), n};
    for (const std::uint64_t at : grid.bricks_around(bound.position, extent_)) {
      List& list = grid.list_for(at);
      list.insert(std::upper_bound(list.begin(), list.end(), listed, is_smaller), listed);
    }
    if (grid.is_narrow) mark_blocks(bound.position, grid.brick, 1U << static_cast<unsigned>(&grid - grids_.data()));
  }
}

template <class Visit>
void SizeBounds::visit_lists(const Vector3d& x, Visit&& visit) const {
  if (bounds_.empty()) return;
  const std::uint32_t narrow_grids = grids_at_block_[number_of(cell_of(x, block * voxel_, blocks_), blocks_)];
  for (std::size_t g = 0; g < grids_.size(); ++g) {
    const Grid& grid = grids_[g];
    if (grid.is_narrow && (narrow_grids >> g & 1U) == 0) continue;
    const std::int32_t list = grid.list_at(x);
    if (list >= 0) visit(grid.lists[static_cast<std::size_t>(list)]);
  }
}

template <class Visit>
void SizeBounds::visit_reaching(const Vector3d& x, Visit&& visit) const {
  visit_lists(x, [&](const List& list) {
    for (const Listed& listed : list) {
      if ((x - listed.position).norm() <= listed.reach) visit(listed.number);
    }
  });
}

double SizeBounds::bound(std::size_t n, const Vector3d& x) const {
  const SizeBound& bound = bounds_[n];
  const double away = (x - bound.position).norm();
  if (away > reach_of(bound)) return infinite;
  const double out = std::max(0.0, away - bound.plateau);
  const double beyond = std::max(0.0, out / bound.scale - 1.0);
  return bound.h + delta_ * out + 0.125 * beyond * beyond * bound.scale;
}

double SizeBounds::bound(const Vector3d& x) const {
  constexpr double rounding = 1.0 + 1e-9;
  double least = infinite;
  visit_lists(x, [&](const List& list) {
    for (const Listed& listed : list) {
      if (listed.h >= least) return;
      // Farther away, the bound has ended or is above `least`, whatever the rounding.
      const double farthest = rounding * std::min(listed.reach, listed.plateau + (least - listed.h) / delta_);
      if ((x - listed.position).squaredNorm() <= farthest * farthest) least = std::min(least, bound(listed.number, x));
    }
  });
  return least;
}

std::vector<std::uint32_t> SizeBounds::reaching(const Vector3d& x) const {
  std::vector<std::uint32_t> found;
  visit_reaching(x, [&found](std::uint32_t n) { found.push_back(n); });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<std::uint32_t> SizeBounds::reaching(const Eigen::AlignedBox3d& box) const {
  std::vector<std::uint32_t> found;
  for (std::uint32_t n = 0; n < bounds_.size(); ++n) {
    if (box.exteriorDistance(bounds_[n].position) <= reach_of(bounds_[n])) found.push_back(n);
  }
  return found;
}

double SizeBounds::scaled_distance(const Vector3d& x, std::size_t first) const {
  double least = infinite;
  visit_reaching(x, [&](std::uint32_t n) {
    if (n >= first) least = std::min(least, (x - bounds_[n].position).norm() / bounds_[n].scale);
  });
  return least;
}

}  // namespace isobench::particles
