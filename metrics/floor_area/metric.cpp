#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "isobench/metrics/metric_input.h"

namespace isobench {
namespace {

std::optional<double> floor_area_percent(const TriangleMesh& mesh, const std::vector<double>& h0, double floor) {
  if (floor <= 0.0) return 0.0;
  // The field is stored in single precision, so a node on the floor is within half an ulp of it.
  const double on_floor = floor * (1.0 + 4.0 * static_cast<double>(std::numeric_limits<float>::epsilon()));
  double area_sum = 0.0;
  double floor_sum = 0.0;
  for (const Triangle& c : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.vertices[c[0]];
    const double area = 0.5 * (mesh.vertices[c[1]] - a).cross(mesh.vertices[c[2]] - a).norm();
    const auto corners = std::count_if(c.begin(), c.end(), [&](std::uint32_t v) { return h0[v] <= on_floor; });
    area_sum += area;
    floor_sum += area * static_cast<double>(corners) / 3.0;
  }
  if (area_sum <= 0.0) return std::nullopt;
  return 100.0 * floor_sum / area_sum;
}

void measure(MetricInput& input, MetricOutput& output) {
  output.set("floor_area_percent", floor_area_percent(input.mesh(), input.h0(), input.sizing().floor_length()));
}

}  // namespace

Metric metric_floor_area() {
  Metric metric;
  metric.name = "floor_area";
  metric.stage = "shape";
  metric.needs = Needs::sizing;
  metric.in_every_record = true;
  metric.figures = {
      {.name = "floor_area_percent",
       .unit = "%",
       .definition = "Share of the mesh's area where h0 is its floor, because curvature or feature size asks for less. "
                     "Each corner of a triangle stands for a third of the triangle's area.",
       .unmeasured = "the mesh has no area",
       .column = 19}};
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
