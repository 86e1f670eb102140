// Signs of the cotangent weights. Where an edge's weight is negative, a mesh's Laplacian has no maximum principle:
// solutions may exceed their boundary values, and harmonic maps may fold (Wardetzky et al. 2007).
#pragma once

#include <cstddef>

#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/metrics/mesh_edges/mesh_edges.h"

namespace isobench {

struct CotangentWeights {
  std::size_t negative = 0;           ///< edges with cot α + cot β below −1e-9
  double negative_row_percent = 0.0;  ///< of the vertices with triangles, those that such an edge ends at
  double obtuse_percent = 0.0;        ///< of the triangles, those with an angle whose cotangent is below −1e-9
};

/// Linear time. Triangles with two equal corners are left out. An edge of a triangle without area counts as negative if
/// the angle opposite to it is 180°.
CotangentWeights measure_cotangent_weights(const TriangleMesh& mesh, const std::vector<HalfEdge>& sides);

}  // namespace isobench
