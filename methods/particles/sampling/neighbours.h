// Lists of nearby particles, where each particle has a reach of its own.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace isobench::particles {

/// The neighbours of particle i are `count[i]` entries of `items` from `first[i]` on.
struct NeighbourLists {
  std::vector<std::uint64_t> first;
  std::vector<std::uint32_t> count;
  std::vector<std::uint32_t> items;

  std::span<const std::uint32_t> of(std::size_t i) const { return {items.data() + first[i], count[i]}; }
};

/// All pairs with |x_i − x_j| < min(reach_i, reach_j); each pair is in both lists. `reach` > 0 has one entry per
/// point, mm. Uses grids whose cell size doubles from one to the next; a particle is in the grid whose cells are one to
/// two times as wide as its reach. Time is linear in the number of points and pairs. Multi-threaded; the order within a
/// list does not depend on the number of threads.
NeighbourLists find_neighbours(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& reach);

}  // namespace isobench::particles
