// Morton order: points that are near in space come near in memory.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace isobench::particles {

/// Sorts points along a Z-curve of 2²¹ cells an axis over their bounding box. Equal cells keep their order.
void sort_by_morton(std::vector<Eigen::Vector3d>& points);

}  // namespace isobench::particles
