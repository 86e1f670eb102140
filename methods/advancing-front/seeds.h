// Where fronts start: once on every component of the surface, as marching cubes shows them.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/methods/advancing-front/apex.h"
#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench::advancing_front {

struct Component {
  std::vector<std::uint32_t> vertices;  ///< of the lattice's mesh, ascending
  Eigen::AlignedBox3d box;              ///< mm
  double diagonal() const { return box.diagonal().norm(); }
};

/// The components of a mesh, largest first.
std::vector<Component> components_of(const TriangleMesh& mesh);

/// Those of the components on which no vertex of the others stands: a vertex stands on the component of the lattice
/// vertex nearest to it, unless their normals are opposed (another sheet, close by).
std::vector<Component> components_without(const Isosurface& surface, const TriangleMesh& mesh,
                                          const std::vector<Component>& components,
                                          const std::vector<Vertex>& vertices);

/// Places to start from on a component, in the order to try them: a few of its vertices drawn at random, those with the
/// longest step first, because growing smaller is safer than growing larger.
std::vector<Eigen::Vector3d> starting_points(const TriangleMesh& mesh, const Component& component, const Step& step,
                                             std::uint64_t seed);

/// A triangle with sides of about the step round a point near the surface, turned at random, counter-clockwise from
/// outside. std::nullopt where the surface bends too much for it.
std::optional<std::array<Vertex, 3>> seed_triangle(const Isosurface& surface, const Step& step,
                                                   const Eigen::Vector3d& near, std::uint64_t seed);

}  // namespace isobench::advancing_front
