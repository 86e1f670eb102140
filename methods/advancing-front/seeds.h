// Where fronts start: once on every component of the surface, as marching cubes shows them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "datasets/isosurface.h"
#include "methods/advancing-front/apex.h"
#include "methods/triangle_mesh.h"

namespace isobench::advancing_front {

struct Component {
  std::vector<std::uint32_t> vertices;  ///< of the lattice's mesh, ascending
  double diagonal = 0.0;                ///< mm, of its bounding box
};

/// The components of a mesh, largest first.
std::vector<Component> components_of(const TriangleMesh& mesh);

/// Places to start from on a component, in the order to try them: a few of its vertices drawn at random, those with the
/// longest step first, because growing smaller is safer than growing larger.
std::vector<Eigen::Vector3d> starting_points(const TriangleMesh& mesh, const Component& component, const Step& step,
                                             std::uint64_t seed);

/// A triangle with sides of about the step round a point near the surface, turned at random, counter-clockwise from
/// outside. std::nullopt where the surface bends too much for it.
std::optional<std::array<Vertex, 3>> seed_triangle(const Isosurface& surface, const Step& step,
                                                   const Eigen::Vector3d& near, std::uint64_t seed);

}  // namespace isobench::advancing_front
