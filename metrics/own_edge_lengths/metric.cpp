// Edge lengths over the h0 of the sizing field that the method computed for itself. They answer whether the method
// kept its own bound; edge_lengths answers whether the mesh keeps the bound that is the same for all methods.
#include "isobench/metrics/edge_lengths/edge_lengths.h"
#include "isobench/metrics/metric_input.h"

namespace isobench {
namespace {

void measure(MetricInput& input, MetricOutput& output) {
  if (input.edges().ends.empty()) return;
  const auto own = input.mesh().vertex_data.find(own_h0);
  const std::vector<double>& h0 = own == input.mesh().vertex_data.end() ? input.h0() : own->second;
  const EdgeLengthFigures figures = measure_edge_lengths(input.mesh(), input.edges(), h0);
  output.set("edge_over_own_h0_max", figures.over_h0_max);
  output.set("edge_over_own_h0_exceed_percent", figures.exceed_percent);
  output.set("edge_over_own_h0_exceed_triangle_percent", figures.exceed_triangle_percent);
}

}  // namespace

Metric metric_own_edge_lengths() {
  Metric metric;
  metric.name = "own_edge_lengths";
  metric.stage = "shape";
  metric.needs = Needs::sizing;
  metric.figures = {
      {.name = "edge_over_own_h0_max",
       .definition = "Largest ratio of an edge's length to the mean, at its two ends, of the method's own h0. Some "
                     "methods compute h0 in another way, for example from another medial axis. For the other methods "
                     "this equals edge_over_h0_max.",
       .better = Better::smaller,
       .column = 17},
      {.name = "edge_over_own_h0_exceed_percent",
       .unit = "%",
       .definition = "Edges longer than the mean of the method's own h0 at their ends, as a percentage of all edges. "
                     "It tells whether the method keeps its own bound, not whether that bound is right. For methods "
                     "without an h0 of their own this equals edge_over_h0_exceed_percent.",
       .better = Better::smaller,
       .column = 18},
      {.name = "edge_over_own_h0_exceed_triangle_percent",
       .unit = "%",
       .definition = "Triangles with at least one edge longer than the mean of the method's own h0 at its ends, as a "
                     "percentage of all triangles.",
       .better = Better::smaller,
       .column = no_column}};
  for (FigureDeclaration& figure : metric.figures) figure.unmeasured = no_edges;
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
