// The components that a surface has on its lattice, to see whether particles stand on each of them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/methods/sizing/medial_axis/point_tree.h"

namespace isobench::particles {

class LatticeComponents {
 public:
  /// Keeps a reference to the mesh.
  explicit LatticeComponents(const TriangleMesh& mesh);

  /// The component on which each point stands, that of the vertex nearest to it: a number of the mesh's own.
  std::vector<std::uint32_t> of(const std::vector<Eigen::Vector3d>& points) const;

  /// Of each component that is no used point's: up to 16 of its vertices, well apart. One entry a point.
  std::vector<std::vector<Eigen::Vector3d>> without(const std::vector<std::uint32_t>& of_points,
                                                    const std::vector<char>& used) const;

 private:
  const TriangleMesh& mesh_;
  std::vector<std::uint32_t> of_vertex_;
  std::optional<PointTree> tree_;  // of the vertices; where all are on one component, there is nothing to look for
};

}  // namespace isobench::particles
