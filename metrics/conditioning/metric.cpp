#include "isobench/metrics/conditioning/conditioning.h"
#include "isobench/metrics/metric_input.h"

namespace isobench {
namespace {

void measure(MetricInput& input, MetricOutput& output) {
  const FiniteElements& elements = input.finite_elements();
  if (!elements.regular) return;
  const ScreenedSystem& system = input.screened_system();
  output.set("condition", condition(elements, system, input.monitor()));
  output.set("cg_iterations", jacobi_steps(system, input.monitor()));
}

}  // namespace

Metric metric_conditioning() {
  const std::string flat = no_stiffness;
  Metric metric;
  metric.name = "conditioning";
  metric.when = When::on_request;
  metric.figures = {
      {.name = "condition",
       .definition =
           "Condition number of D^-½ A D^-½ times h²/L², for A = K + M/L² of linear finite elements (stiffness K, "
           "consistent mass M) and its diagonal D; 6 for a lattice of equilateral triangles. L² is the mesh's "
           "area over 4π, h² is (4/√3) times the mean area of a triangle.",
       .better = Better::smaller,
       .unmeasured = flat + ", or slivers leave no digits"},
      {.name = "cg_iterations",
       .definition = "Steps of conjugate gradients with the preconditioner D that solve A x = b, for the A and D of "
                     "condition and a b of random numbers, until the residual is 1e-8 of b in the norm of D⁻¹.",
       .kind = Kind::count,
       .better = Better::smaller,
       .unmeasured = flat + ", or 20,000 steps are not enough"}};
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
