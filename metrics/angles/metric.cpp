#include "isobench/metrics/angles/angles.h"
#include "isobench/metrics/metric_input.h"

namespace isobench {
namespace {

void measure(MetricInput& input, MetricOutput& output) {
  AngleFigures figures = measure_angles(input.mesh());
  output.set("angle_min", figures.min);
  output.set("angle_max", figures.max);
  output.set("angle", std::move(figures.histogram));
}

}  // namespace

Metric metric_angles() {
  Metric metric;
  metric.name = "angles";
  metric.stage = "shape";
  metric.in_every_record = true;
  metric.figures = {{.name = "angle_min",
                     .unit = "°",
                     .definition = "Smallest angle of any triangle.",
                     .better = Better::larger,
                     .column = 6},
                    {.name = "angle_max",
                     .unit = "°",
                     .definition = "Largest angle of any triangle.",
                     .better = Better::smaller,
                     .column = 7}};
  metric.histograms = {{.name = "angle", .low = 0.0, .high = 180.0, .bins = 180}};
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
