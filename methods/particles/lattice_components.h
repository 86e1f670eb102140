// The components that a surface has on its lattice, to see whether particles stand on each of them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "methods/sizing/point_tree.h"
#include "methods/triangle_mesh.h"

namespace isobench::particles {

class LatticeComponents {
 public:
  /// Keeps a reference to the mesh.
  explicit LatticeComponents(const TriangleMesh& mesh);

  /// Of each component on which no used point stands: up to 16 of its vertices, well apart. A point stands on the
  /// component of the vertex nearest to it. Later calls must give the points of earlier ones first, as they were: only
  /// new ones are looked for.
  std::vector<std::vector<Eigen::Vector3d>> without(const std::vector<Eigen::Vector3d>& points,
                                                    const std::vector<char>& used);

 private:
  const TriangleMesh& mesh_;
  PointTree tree_;
  std::vector<std::uint32_t> of_vertex_;
  std::vector<std::uint32_t> of_point_;
};

}  // namespace isobench::particles
