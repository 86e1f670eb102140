// The components of F = c on which a triangulation has no triangle.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "isobench/datasets/topology/certified_topology.h"

namespace isobench::particles {

/// For each component to which no counted point belongs and that is not left out: up to 16 points, spread over it.
/// `of_points` (components_at()) and `counted` have one entry for each point; a point counts if its entry in `counted`
/// is not 0.
std::vector<std::vector<Eigen::Vector3d>> lost_components(const Isosurface& surface, const CertifiedTopology& topology,
                                                          const std::vector<std::uint32_t>& of_points,
                                                          const std::vector<char>& counted);

}  // namespace isobench::particles
