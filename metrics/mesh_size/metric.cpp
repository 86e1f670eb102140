#include "isobench/metrics/metric_input.h"

namespace isobench {
namespace {

void measure(MetricInput& input, MetricOutput& output) {
  output.set("vertices", static_cast<double>(input.mesh().vertices.size()));
  output.set("triangles", static_cast<double>(input.mesh().triangles.size()));
}

}  // namespace

Metric metric_mesh_size() {
  Metric metric;
  metric.name = "mesh_size";
  metric.stage = "shape";
  metric.in_every_record = true;
  metric.figures = {
      {.name = "vertices", .definition = "Number of vertices in the mesh.", .kind = Kind::count, .column = 1},
      {.name = "triangles", .definition = "Number of triangles in the mesh.", .kind = Kind::count, .column = 2}};
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
