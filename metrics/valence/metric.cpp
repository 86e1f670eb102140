#include "isobench/metrics/metric_input.h"
#include "isobench/metrics/valence/valence.h"

namespace isobench {
namespace {

void measure(MetricInput& input, MetricOutput& output) {
  const std::vector<int> valence = valences(input.mesh(), input.edges());
  const ValenceFigures figures = summarize_valences(valence);
  output.set("unused_vertices", static_cast<double>(figures.unused_vertices));
  output.add_vertex_data("valence", {valence.begin(), valence.end()});
  if (figures.counts.empty()) return;
  output.set("valence_lt5_percent", figures.lt5_percent);
  output.set("valence_5_percent", figures.v5_percent);
  output.set("valence_6_percent", figures.v6_percent);
  output.set("valence_7_percent", figures.v7_percent);
  output.set("valence_gt7_percent", figures.gt7_percent);
  output.set("valence_extreme_count", static_cast<double>(figures.extreme_count));
  Histogram histogram(0.0, static_cast<double>(figures.counts.size()), 0);
  histogram.counts.assign(figures.counts.begin(), figures.counts.end());
  output.set("valence", std::move(histogram));
}

FigureDeclaration percent(const std::string& name, const std::string& which, int column, Better better) {
  return {.name = name,
          .unit = "%",
          .definition = "Vertices with " + which + " edges, as a percentage of the vertices that have a triangle.",
          .better = better,
          .unmeasured = no_edges,
          .column = column};
}

}  // namespace

Metric metric_valence() {
  Metric metric;
  metric.name = "valence";
  metric.stage = "shape";
  metric.in_every_record = true;
  metric.figures = {percent("valence_lt5_percent", "fewer than five", 8, Better::smaller),
                    percent("valence_5_percent", "five", 9, Better::neither),
                    percent("valence_6_percent", "six", 10, Better::larger),
                    percent("valence_7_percent", "seven", 11, Better::neither),
                    percent("valence_gt7_percent", "more than seven", 12, Better::smaller),
                    {.name = "valence_extreme_count",
                     .definition = "Number of vertices with fewer than five or more than seven edges.",
                     .kind = Kind::count,
                     .better = Better::smaller,
                     .unmeasured = no_edges,
                     .column = 13},
                    {.name = "unused_vertices",
                     .definition = "Number of vertices without a triangle. The valences leave them out.",
                     .kind = Kind::count,
                     .better = Better::smaller,
                     .column = no_column}};
  metric.figures[2].definition += " A regular mesh has valence 6.";
  metric.histograms = {{.name = "valence"}};
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
