// Topology of a mesh: components, Euler characteristic, and everything that keeps it from being a closed manifold.
// Taken from the indices alone (self-intersections excepted): vertices at the same place are different vertices.
// A triangle that names a vertex twice is left out. About 0.3 s per million triangles without self-intersections.
#pragma once

#include <cstddef>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

struct TopologyFigures {
  std::size_t components = 0;            ///< triangles connected over edges
  long euler = 0;                        ///< χ = V − E + F of the used vertices
  std::size_t boundary_edges = 0;        ///< edges of one triangle
  std::size_t nonmanifold_edges = 0;     ///< edges of three or more triangles
  std::size_t misoriented_edges = 0;     ///< edges of two triangles that run through it in the same direction
  std::size_t nonmanifold_vertices = 0;  ///< vertices whose triangles form more than one fan ("pinches")
  std::size_t self_intersections = 0;    ///< pairs of triangles that meet where they share no vertex or edge (CGAL)
  bool closed_manifold() const {
    return boundary_edges + nonmanifold_edges + misoriented_edges + nonmanifold_vertices == 0;
  }
};
TopologyFigures measure_topology(const TriangleMesh& mesh);

/// The same with self_intersections left 0: what the indices alone say.
TopologyFigures measure_connectivity(const TriangleMesh& mesh);

}  // namespace isobench
