// Morton order: points that are near in space come near in memory.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace isobench {

/// The points' indices along a Z-curve of 2²¹ cells an axis over their bounding box; those of one cell ascend.
std::vector<std::uint32_t> morton_order(const std::vector<Eigen::Vector3d>& points);

void sort_by_morton(std::vector<Eigen::Vector3d>& points);

}  // namespace isobench
