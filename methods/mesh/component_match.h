// Which components of F = c a mesh shows, and which of them as they are.
#pragma once

#include <cstdint>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/datasets/topology/certified_topology.h"
#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

/// How a component of F = c is in a mesh.
enum class Shown : std::uint8_t {
  right,      ///< as one piece of the mesh with the same Euler characteristic
  lost,       ///< not at all
  joined,     ///< its piece also shows another component
  different,  ///< as several pieces, or as one with another Euler characteristic
  left_out,   ///< it need not be shown (SurfaceComponent::is_left_out)
};

struct ComponentMatch {
  std::vector<Shown> shown;              ///< of each component of F = c
  std::vector<std::uint32_t> of_vertex;  ///< the component of F = c nearest to each vertex
};

/// The mesh is in the lattice frame; unused vertices do not count. Precondition: the topology is proven. Threads: all;
/// the result does not depend on their number. Cost: a projection to F = c for each vertex, and a sort of the edges.
ComponentMatch match_components(const TriangleMesh& mesh, const Isosurface& surface, const CertifiedTopology& topology);

/// Removes the pieces of a mesh that show nothing but components that are left out. Does nothing if none is left out.
void drop_left_out(TriangleMesh& mesh, const Isosurface& surface, const CertifiedTopology& topology);

}  // namespace isobench
