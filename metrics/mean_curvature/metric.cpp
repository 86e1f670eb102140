#include "isobench/metrics/mean_curvature/mean_curvature.h"
#include "isobench/metrics/metric_input.h"

namespace isobench {
namespace {

void measure(MetricInput& input, MetricOutput& output) {
  const FiniteElements& elements = input.finite_elements();
  if (!elements.regular) return;
  const std::vector<FootPoint> feet = foot_points(input.surface(), input.mesh().vertices);
  if (!any_projected(feet)) return;
  output.set("curvature_max", curvature_error(elements, input.mesh(), feet));
}

}  // namespace

Metric metric_mean_curvature() {
  Metric metric;
  metric.name = "mean_curvature";
  metric.stage = "distance";
  metric.needs = Needs::surface;
  metric.figures = {
      {.name = "curvature_max",
       .definition =
           "Largest error of the mean curvature that the mesh's Laplacian shows: from K x/(2M) at a vertex, with "
           "the stiffness K and the lumped mass M of linear finite elements, to the mean curvature times "
           "the normal of F = c at the vertex's projection; over the root mean square of the mean curvature. "
           "Vertices at open edges do not count.",
       .better = Better::smaller,
       .unmeasured =
           std::string(no_stiffness) + ", no point of it could be projected to the surface, or that is flat"}};
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
