#include <algorithm>

#include "isobench/metrics/metric_input.h"
#include "isobench/metrics/poisson/poisson.h"

namespace isobench {
namespace {

void measure(MetricInput& input, MetricOutput& output) {
  const FiniteElements& elements = input.finite_elements();
  if (!elements.regular) return;
  const std::vector<FootPoint> feet = foot_points(input.surface(), input.mesh().vertices);
  output.set("gradient_max",
             gradient_error(elements, input.mesh(), feet, foot_points(input.surface(), centroids(input.mesh()))));
  const bool closed = std::count(elements.on_border.begin(), elements.on_border.end(), 0) == elements.size();
  const bool all = std::all_of(elements.vertex.begin(), elements.vertex.end(), [&](auto v) { return feet[v].exists; });
  if (!closed || !all) return;
  // Reports add these seconds to those of meshing.
  const auto stage = input.monitor().stage("solve");
  if (const auto errors = poisson_errors(elements, feet)) {
    output.set("poisson_max", errors->max);
    output.set("poisson_l2", errors->l2);
  }
}

}  // namespace

Metric metric_poisson() {
  const std::string unless =
      std::string(no_stiffness) + ", it is not closed, an edge has more than two triangles, or slivers leave no digits";
  Metric metric;
  metric.name = "poisson";
  metric.when = When::on_request;
  metric.needs = Needs::surface;
  metric.figures = {
      {.name = "poisson_max",
       .definition =
           "Largest error at a vertex of linear finite elements for u/L² − Δu = f on the surface F = c, over the "
           "root mean square of the solution u. It is u = sin(2 a·x/L) + cos(2 b·x/L) with the fixed unit "
           "vectors a = (2, 3, 6)/7 and b = (3, −6, 2)/7 in the lattice frame; f follows from the normal and the "
           "mean curvature of F = c at the projections of the vertices. L² is the mesh's area over 4π.",
       .unmeasured = unless},
      {.name = "poisson_l2",
       .definition =
           "Root mean square of the errors of poisson_max, weighted by the area of each vertex, over the root "
           "mean square of u.",
       .unmeasured = unless},
      {.name = "gradient_max",
       .definition = "Largest error of the gradient in a triangle, if the u of poisson_max is interpolated between its "
                     "values at the corners' projections: to the gradient of u along F = c at the projection of the "
                     "triangle's centroid, over its root mean square.",
       .unmeasured = no_stiffness}};
  for (FigureDeclaration& figure : metric.figures) figure.better = Better::smaller;
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
