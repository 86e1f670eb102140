#include "isobench/metrics/edge_lengths/edge_lengths.h"
#include "isobench/metrics/metric_input.h"

namespace isobench {
namespace {

void measure(MetricInput& input, MetricOutput& output) {
  output.add_vertex_data("h0", input.h0());
  if (input.edges().ends.empty()) return;
  EdgeLengthFigures figures = measure_edge_lengths(input.mesh(), input.edges(), input.h0());
  output.set("edge_over_h0_max", figures.over_h0_max);
  output.set("edge_over_h0_mean", figures.over_h0_mean);
  output.set("edge_over_h0_exceed_percent", figures.exceed_percent);
  output.set("edge_over_h0_exceed_count", static_cast<double>(figures.exceed_count));
  output.set("edge_over_h0_exceed_triangle_percent", figures.exceed_triangle_percent);
  output.set("edge_over_h0", std::move(figures.histogram));
}

}  // namespace

Metric metric_edge_lengths() {
  Metric metric;
  metric.name = "edge_lengths";
  metric.stage = "shape";
  metric.needs = Needs::sizing;
  metric.in_every_record = true;
  metric.figures = {
      {.name = "edge_over_h0_max",
       .definition = "Largest ratio of an edge's length to the mean of h0 at its two ends. Above 1 the mesh misses the "
                     "sampling bound. h0 = max(floor, 2ε min(λ, 1/|κ_max|)), where λ is the local feature size and "
                     "|κ_max| the larger magnitude of the principal curvatures; its gradient is not limited. If a "
                     "uniform size was asked for, h0 is that edge length.",
       .better = Better::smaller,
       .column = 14},
      {.name = "edge_over_h0_mean",
       .definition = "Mean ratio of an edge's length to the mean of h0 at its ends. Each edge counts the same.",
       .column = no_column},
      {.name = "edge_over_h0_exceed_percent",
       .unit = "%",
       .definition = "Edges longer than the mean of h0 at their ends, as a percentage of all edges.",
       .better = Better::smaller,
       .column = 15},
      {.name = "edge_over_h0_exceed_count",
       .definition = "Number of edges longer than the mean of h0 at their ends.",
       .kind = Kind::count,
       .better = Better::smaller,
       .column = 16},
      {.name = "edge_over_h0_exceed_triangle_percent",
       .unit = "%",
       .definition = "Triangles with at least one edge longer than the mean of h0 at its ends, as a percentage of all "
                     "triangles. The paper counts in this way.",
       .better = Better::smaller,
       .column = no_column}};
  for (FigureDeclaration& figure : metric.figures) figure.unmeasured = no_edges;
  metric.histograms = {{.name = "edge_over_h0", .low = 0.0, .high = 2.0, .bins = 200}};
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
