#include "isobench/metrics/metric_input.h"
#include "isobench/metrics/radius_ratio/radius_ratio.h"

namespace isobench {
namespace {

void measure(MetricInput& input, MetricOutput& output) {
  std::vector<double> ratios = radius_ratios(input.mesh());
  RadiusRatioFigures figures = summarize_radius_ratios(ratios);
  output.set("radius_ratio_min", figures.min);
  output.set("radius_ratio_p01", figures.p01);
  output.set("radius_ratio_avg", figures.avg);
  output.set("radius_ratio", std::move(figures.histogram));
  output.add_triangle_data("radius_ratio", std::move(ratios));
}

}  // namespace

Metric metric_radius_ratio() {
  Metric metric;
  metric.name = "radius_ratio";
  metric.stage = "shape";
  metric.in_every_record = true;
  metric.figures = {
      {.name = "radius_ratio_min",
       .definition = "Smallest radius ratio Q = 2 r_in / r_circ of any triangle. r_in is the radius of the inscribed "
                     "circle, r_circ of the circumscribed circle: Q is 1 for an equilateral triangle and 0 for a "
                     "triangle without area.",
       .better = Better::larger,
       .column = 3},
      {.name = "radius_ratio_p01",
       .definition = "0.1 percentile of the radius ratio, by nearest rank: of n triangles the ⌈n/1000⌉-th smallest "
                     "value.",
       .better = Better::larger,
       .column = 4},
      {.name = "radius_ratio_avg",
       .definition = "Mean radius ratio. Each triangle counts the same.",
       .better = Better::larger,
       .column = 5}};
  metric.histograms = {{.name = "radius_ratio", .low = 0.0, .high = 1.0, .bins = 100}};
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
