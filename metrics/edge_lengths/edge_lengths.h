// Edge length over the mean of h0 at the edge's ends (Meyer, Kirby, Whitaker 2007, Figures 3 and 4): above 1 the mesh
// misses the sampling bound. h0 is equation 1 with its floor, before its gradient is limited, whatever method made the
// mesh. For a uniform request it is the edge length that was asked for.
#pragma once

#include <cstddef>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/metrics/histogram.h"
#include "isobench/metrics/mesh_edges/mesh_edges.h"

namespace isobench {

struct EdgeLengthFigures {
  double over_h0_max = 0.0;
  double over_h0_mean = 0.0;             ///< each edge counts the same
  double exceed_percent = 0.0;           ///< of edges
  std::size_t exceed_count = 0;          ///< edges
  double exceed_triangle_percent = 0.0;  ///< of triangles: those with such an edge, as the paper counts
  Histogram histogram{0.0, 2.0, 200};
};

/// `h0` holds one value a vertex, mm; where it is 0, the ratio is infinite.
EdgeLengthFigures measure_edge_lengths(const TriangleMesh& mesh, const MeshEdges& edges, const std::vector<double>& h0);

}  // namespace isobench
