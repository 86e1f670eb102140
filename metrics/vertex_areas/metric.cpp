// Areas of vertices: a third of the area of the triangles around each.
#include <numbers>

#include "isobench/metrics/finite_elements/finite_elements.h"
#include "isobench/metrics/metric_input.h"

namespace isobench {
namespace {

void measure(MetricInput& input, MetricOutput& output) {
  const FiniteElements& elements = input.finite_elements();
  if (!(elements.area > 0.0)) return;
  const Eigen::ArrayXd h = asked_lengths(elements, input.mesh(), input.sizing_if_given()).array();
  const Eigen::ArrayXd ratios = elements.lumped_mass.array() / (0.5 * std::numbers::sqrt3 * h.square());
  output.set("vertex_area_min", ratios.minCoeff());
  output.set("vertex_area_max", ratios.maxCoeff());
}

}  // namespace

Metric metric_vertex_areas() {
  const std::string area =
      " area of a vertex, a third of that of its triangles, over the area (√3/2)h² that was asked for there. The sizes "
      "h "
      "are scaled by one factor so that these areas sum to the mesh's. With edges of one length, or without a sizing, "
      "this is the area over its mean.";
  Metric metric;
  metric.name = "vertex_areas";
  metric.stage = "shape";
  metric.figures = {{.name = "vertex_area_min", .definition = "Smallest" + area, .better = Better::larger},
                    {.name = "vertex_area_max", .definition = "Largest" + area, .better = Better::smaller}};
  for (FigureDeclaration& figure : metric.figures) figure.unmeasured = "the mesh has no area";
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
