// Where fronts start: on every component of the marching cubes mesh.
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

/// The components on which none of `vertices` lies. A vertex lies on the component of the nearest lattice vertex,
/// unless their normals are opposed: then that lattice vertex is on another sheet.
std::vector<Component> components_without(const Isosurface& surface, const TriangleMesh& mesh,
                                          const std::vector<Component>& components,
                                          const std::vector<Vertex>& vertices);

/// Points of a component to start from, in the order to try them: 32 of its vertices drawn at random, longest step
/// first, because a front that advances towards smaller steps fails less often.
std::vector<Eigen::Vector3d> starting_points(const TriangleMesh& mesh, const Component& component, const Step& step,
                                             std::uint64_t seed);

/// A triangle on the surface round the projection of `near`, with sides of about one step, at a random angle,
/// counter-clockwise from outside. std::nullopt if the surface bends too much for such a triangle.
std::optional<std::array<Vertex, 3>> seed_triangle(const Isosurface& surface, const Step& step,
                                                   const Eigen::Vector3d& near, std::uint64_t seed);

}  // namespace isobench::advancing_front
