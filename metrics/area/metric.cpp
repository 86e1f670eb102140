#include <Eigen/Geometry>

#include "isobench/metrics/metric_input.h"

namespace isobench {
namespace {

void measure(MetricInput& input, MetricOutput& output) {
  const std::vector<Eigen::Vector3d>& x = input.mesh().vertices;
  double area = 0.0;
  for (const Triangle& t : input.mesh().triangles) area += 0.5 * (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).norm();
  output.set("area", area);
}

}  // namespace

Metric metric_area() {
  Metric metric;
  metric.name = "area";
  metric.stage = "shape";
  metric.figures = {{.name = "area", .unit = "mm²", .definition = "Sum of the triangles' areas.", .column = 903}};
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
