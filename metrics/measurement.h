// Everything that is measured of one mesh, by one call.
#pragma once

#include <string>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/methods/sizing/sizing_field.h"
#include "isobench/metrics/distance/distance.h"
#include "isobench/metrics/distance/distance_from_surface.h"
#include "isobench/metrics/shape/angles.h"
#include "isobench/metrics/shape/edge_lengths.h"
#include "isobench/metrics/shape/radius_ratio.h"
#include "isobench/metrics/shape/valence.h"
#include "isobench/metrics/topology/reference_topology.h"
#include "isobench/metrics/topology/topology.h"

namespace isobench {

/// Raised when the meaning or the value of a figure changes: stored results of another revision are not reused.
inline constexpr int metrics_revision = 4;

struct Measurement {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  RadiusRatioFigures radius_ratio;
  AngleFigures angles;
  ValenceFigures valence;
  EdgeLengthFigures edges;
  TopologyFigures topology;
  ReferenceTopology reference;
  DistanceFigures distance;
  DistanceFromSurface distance_from_surface;
};

/// Measures a mesh (lattice frame) against the surface and the sizing that it was asked for, and adds the arrays that a
/// reader may want to see to it: "radius_ratio" a triangle; "valence", "h0" and "distance" a vertex.
/// Throws DataError for a mesh without triangles, indices out of range or coordinates that are not finite or beyond
/// 1e12 mm.
Measurement measure(TriangleMesh& mesh, const Isosurface& surface, const SizingField& sizing, int reference_k,
                    Monitor& monitor);

/// The definition of each metric in words, for tables and `isobench list metrics`.
struct MetricDefinition {
  std::string name;
  std::string unit;
  std::string definition;
};
const std::vector<MetricDefinition>& metric_definitions();

}  // namespace isobench
