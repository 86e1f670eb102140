// Who is near whom among particles whose reach varies from place to place.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace isobench::particles {

/// For each particle a stretch of `items`.
struct NeighbourLists {
  std::vector<std::uint64_t> first;
  std::vector<std::uint32_t> count;
  std::vector<std::uint32_t> items;

  std::span<const std::uint32_t> of(std::size_t i) const { return {items.data() + first[i], count[i]}; }
};

/// All pairs with |x_i − x_j| < min(reach_i, reach_j), in both lists, by grids of doubling cell size: each particle
/// stands in the grid whose cells are as wide as its reach. Time linear in particles and pairs, multi-threaded; the
/// order within a list does not depend on the number of threads. Reaches are > 0, mm.
NeighbourLists find_neighbours(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& reach);

}  // namespace isobench::particles
