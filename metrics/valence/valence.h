// Valence: the number of edges at a vertex (Meyer, Kirby, Whitaker 2007, Table 3). Vertices without a triangle have
// none and are counted apart.
#pragma once

#include <cstddef>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/metrics/mesh_edges/mesh_edges.h"

namespace isobench {

struct ValenceFigures {
  std::vector<std::size_t> counts;  ///< counts[v] = vertices of valence v
  double lt5_percent = 0.0;
  double v5_percent = 0.0;
  double v6_percent = 0.0;
  double v7_percent = 0.0;
  double gt7_percent = 0.0;
  std::size_t extreme_count = 0;  ///< below 5 or above 7
  std::size_t unused_vertices = 0;
};

/// Valence of each vertex.
std::vector<int> valences(const TriangleMesh& mesh, const MeshEdges& edges);
ValenceFigures summarize_valences(const std::vector<int>& valences);

}  // namespace isobench
