#include "isobench/metrics/metric_input.h"
#include "isobench/metrics/time_step/time_step.h"

namespace isobench {
namespace {

void measure(MetricInput& input, MetricOutput& output) {
  const FiniteElements& elements = input.finite_elements();
  if (!elements.regular) return;
  Eigen::VectorXd h = asked_lengths(elements, input.mesh(), input.sizing_if_given());
  if (!input.is_adaptive()) h.setConstant(std::sqrt(elements.mean_squared_edge()));
  output.set("step_factor",
             input.is_adaptive() ? step_factor(elements, h, input.monitor()) : input.uniform_step_factor());
  output.set("step_factor_consistent", consistent_step_factor(elements, h, input.monitor()));
}

}  // namespace

Metric metric_time_step() {
  Metric metric;
  metric.name = "time_step";
  metric.when = When::on_request;
  metric.figures = {
      {.name = "step_factor",
       .definition =
           "Largest eigenvalue of M⁻¹K times h², for the stiffness K and the lumped mass M of linear finite "
           "elements; 6 for a lattice of equilateral triangles. An explicit step of the heat equation is "
           "stable up to 2h² over this. h² is (4/√3) times the mean area of a triangle; with an adaptive "
           "sizing it is the square of the size that was asked for at each vertex, and these sizes are scaled "
           "by one factor so that the areas (√3/2)h² sum to the mesh's.",
       .better = Better::smaller},
      {.name = "step_factor_consistent",
       .definition = "The same as step_factor with the consistent mass; 24 for a lattice of equilateral triangles.",
       .better = Better::smaller}};
  for (FigureDeclaration& figure : metric.figures) figure.unmeasured = no_stiffness;
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
