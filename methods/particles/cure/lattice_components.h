// The components of a lattice mesh, to find those on which there is no particle.
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

  /// For each point, the component of the mesh vertex nearest to it. The numbers of components are arbitrary.
  std::vector<std::uint32_t> components_of(const std::vector<Eigen::Vector3d>& points) const;

  /// For each component to which no counted point belongs: up to 16 of its vertices, spread over it. `of_points` and
  /// `counted` have one entry per point; a point counts if its entry in `counted` is not 0.
  std::vector<std::vector<Eigen::Vector3d>> missing(const std::vector<std::uint32_t>& of_points,
                                                    const std::vector<char>& counted) const;

 private:
  const TriangleMesh& mesh_;
  std::vector<std::uint32_t> of_vertex_;
  std::optional<PointTree> tree_;  // over the vertices; not set if the mesh has one component only
};

}  // namespace isobench::particles
