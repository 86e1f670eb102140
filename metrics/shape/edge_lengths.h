// Edge length over the mean of h0 at the edge's ends (Meyer, Kirby, Whitaker 2007, Figures 3 and 4): above 1 the
// sampling bound is missed. h0 is the unlimited field of equation 1 with its floor, whatever method made the mesh; for
// a uniform request it is the edge length asked for. A method that made a field of its own, from another medial axis
// say, is measured against that one's h0, too: whether its edges are as short as it meant them to be is one question,
// whether what it meant is right another.
#pragma once

#include <cstddef>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/methods/sizing/sizing_field.h"
#include "isobench/metrics/shape/histogram.h"

namespace isobench {

struct EdgeLengthFigures {
  double over_h0_max = 0.0;
  double over_h0_mean = 0.0;             ///< each edge counting the same
  double exceed_percent = 0.0;           ///< of edges
  std::size_t exceed_count = 0;          ///< edges
  double exceed_triangle_percent = 0.0;  ///< of triangles that have such an edge, as the paper counts
  double floor_area_percent = 0.0;       ///< of the mesh's area where h0 sits on its floor: a third of it a corner
  double over_own_h0_max = 0.0;  ///< "own": h0 of the method's own field, where it made one; else the same figures
  double own_exceed_percent = 0.0;
  double own_exceed_triangle_percent = 0.0;
  Histogram histogram{0.0, 2.0, 200};
};

/// The method's own h0 is the mesh's vertex data `own_h0`, where there is such. Where `h0_at_vertices` is given it
/// receives h0 of each vertex, in mm. Cost: one interpolation a vertex, all threads.
EdgeLengthFigures measure_edge_lengths(const TriangleMesh& mesh, const SizingField& sizing,
                                       std::vector<double>* h0_at_vertices = nullptr);

}  // namespace isobench
