// Topology of a mesh: components, Euler characteristic, and the defects that keep it from being a closed manifold.
// All but self-intersections follow from the indices alone: two vertices at one place are different vertices. Triangles
// that name a vertex twice are left out. About 0.3 s per million triangles without self-intersections.
#pragma once

#include <cstddef>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/metrics/measurement.h"
#include "isobench/metrics/mesh_edges/mesh_edges.h"

namespace isobench {

struct TopologyFigures {
  std::size_t components = 0;            ///< triangles connected over edges
  long euler = 0;                        ///< χ = V − E + F of the used vertices
  std::size_t boundary_edges = 0;        ///< edges of one triangle
  std::size_t nonmanifold_edges = 0;     ///< edges of three or more triangles
  std::size_t misoriented_edges = 0;     ///< edges whose two triangles run through them in the same direction
  std::size_t nonmanifold_vertices = 0;  ///< vertices whose triangles form more than one fan ("pinches")
  std::size_t self_intersections = 0;    ///< pairs of triangles that meet where they share no vertex or edge (CGAL)
  bool closed_manifold() const {
    return boundary_edges + nonmanifold_edges + misoriented_edges + nonmanifold_vertices == 0;
  }
};

/// `sides` are sorted_half_edges() of the mesh.
TopologyFigures measure_topology(const TriangleMesh& mesh, const std::vector<HalfEdge>& sides);
TopologyFigures measure_topology(const TriangleMesh& mesh);

/// Everything but self_intersections, which stays 0.
TopologyFigures measure_connectivity(const TriangleMesh& mesh, const std::vector<HalfEdge>& sides);
TopologyFigures measure_connectivity(const TriangleMesh& mesh);

/// Whether the figures say that the mesh is closed, manifold and oriented; false where they were not measured.
bool is_closed_manifold(const Measurement& measurement);

}  // namespace isobench
