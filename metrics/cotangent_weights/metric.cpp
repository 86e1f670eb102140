#include "isobench/metrics/cotangent_weights/cotangent_weights.h"
#include "isobench/metrics/metric_input.h"

namespace isobench {
namespace {

void measure(MetricInput& input, MetricOutput& output) {
  if (input.half_edges().empty()) return;
  const CotangentWeights figures = measure_cotangent_weights(input.mesh(), input.half_edges());
  output.set("negative_weights", static_cast<double>(figures.negative));
  output.set("negative_weight_rows_percent", figures.negative_row_percent);
  output.set("obtuse_percent", figures.obtuse_percent);
}

}  // namespace

Metric metric_cotangent_weights() {
  Metric metric;
  metric.name = "cotangent_weights";
  metric.stage = "shape";
  metric.figures = {
      {.name = "negative_weights",
       .definition = "Number of edges with a negative weight in the mesh's Laplacian: cot α + cot β < −1e-9, with the "
                     "angles opposite to the edge.",
       .kind = Kind::count,
       .better = Better::smaller},
      {.name = "negative_weight_rows_percent",
       .unit = "%",
       .definition = "Share of the vertices that have an edge with a negative weight, which are the rows of the "
                     "Laplacian without a maximum principle.",
       .better = Better::smaller},
      {.name = "obtuse_percent",
       .unit = "%",
       .definition = "Share of the triangles with an angle over 90°, by more than 1e-9 in its cotangent.",
       .better = Better::smaller}};
  for (FigureDeclaration& figure : metric.figures) figure.unmeasured = no_edges;
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
