// The components of F = c on which a triangulation has no triangle.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "isobench/datasets/topology/certified_topology.h"

namespace isobench::particles {

class LostComponents {
 public:
  /// Keeps references.
  LostComponents(const Isosurface& surface, const CertifiedTopology& topology);

  /// For each component to which no counted point belongs and that is not left out: up to 16 points, spread over it; a
  /// component on which none is found is missing. `of_points` (components_at()) and `counted` have one entry for each
  /// point; a point counts if its entry in `counted` is not 0. The first call for a component projects eight points for
  /// each of its boxes; later ones remember the result.
  std::vector<std::vector<Eigen::Vector3d>> find(const std::vector<std::uint32_t>& of_points,
                                                 const std::vector<char>& counted);

 private:
  /// Finds the points of those lost components whose points are not known yet.
  void remember(const std::vector<char>& lost);

  const Isosurface& surface_;
  const CertifiedTopology& topology_;
  std::vector<std::optional<std::vector<Eigen::Vector3d>>> points_;  // of each component that was lost before
};

}  // namespace isobench::particles
