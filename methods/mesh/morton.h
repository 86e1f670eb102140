// Morton order: points that are close in space become close in memory.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace isobench {

/// The indices of the points along a Z-curve over their bounding box, with 2²¹ cells along its longest side. Indices of
/// points in one cell ascend.
std::vector<std::uint32_t> morton_order(const std::vector<Eigen::Vector3d>& points);

/// Sorts the points themselves in that order.
void sort_by_morton(std::vector<Eigen::Vector3d>& points);

}  // namespace isobench
