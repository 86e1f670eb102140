#include "isobench/methods/mesh/morton.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace isobench {

namespace {

/// Inserts two zero bits between any two of the 21 lowest bits.
std::uint64_t spread(std::uint64_t x) {
  x &= 0x1FFFFF;
  x = (x | x << 32) & 0x1F00000000FFFF;
  x = (x | x << 16) & 0x1F0000FF0000FF;
  x = (x | x << 8) & 0x100F00F00F00F00F;
  x = (x | x << 4) & 0x10C30C30C30C30C3;
  x = (x | x << 2) & 0x1249249249249249;
  return x;
}

}  // namespace

std::vector<std::uint32_t> morton_order(const std::vector<Eigen::Vector3d>& points) {
  if (points.empty()) return {};
  Eigen::Vector3d low = points.front();
  Eigen::Vector3d high = points.front();
  for (const Eigen::Vector3d& x : points) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const double scale = static_cast<double>((1 << 21) - 1) / std::max((high - low).maxCoeff(), 1e-300);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> cells(points.size());
  for (std::size_t n = 0; n < points.size(); ++n) {
    const Eigen::Vector3d u = (points[n] - low) * scale;
    const auto cell = [&](int axis) { return spread(static_cast<std::uint64_t>(u[axis])); };
    cells[n] = {cell(0) | cell(1) << 1 | cell(2) << 2, static_cast<std::uint32_t>(n)};
  }
  tbb::parallel_sort(cells.begin(), cells.end());
  std::vector<std::uint32_t> order(points.size());
  for (std::size_t n = 0; n < points.size(); ++n) order[n] = cells[n].second;
  return order;
}

void sort_by_morton(std::vector<Eigen::Vector3d>& points) {
  const std::vector<std::uint32_t> order = morton_order(points);
  std::vector<Eigen::Vector3d> sorted(points.size());
  for (std::size_t n = 0; n < points.size(); ++n) sorted[n] = points[order[n]];
  points = std::move(sorted);
}

}  // namespace isobench
