#include <fmt/format.h>

#include <algorithm>

#include "isobench/metrics/metric_input.h"
#include "isobench/metrics/poisson/poisson.h"

namespace isobench {
namespace {

void measure(MetricInput& input, MetricOutput& output) {
  const FiniteElements& elements = input.finite_elements();
  if (!elements.regular) return;
  const std::vector<FootPoint> feet = foot_points(input.surface(), input.mesh().vertices);
  if (!any_projected(feet)) return;
  if (auto errors =
          gradient_errors(elements, input.mesh(), feet, foot_points(input.surface(), centroids(input.mesh())))) {
    output.set("gradient_max", errors->max);
    output.add_triangle_data("gradient_error", std::move(errors->of_triangles));
  }
  const bool closed = std::count(elements.on_border.begin(), elements.on_border.end(), 0) == elements.size();
  const bool all = std::all_of(elements.vertex.begin(), elements.vertex.end(), [&](auto v) { return feet[v].exists; });
  if (!closed || !all) return;
  const ScreenedSystem& system = input.screened_system();
  // Reports add these seconds, and those of the factors, to those of meshing.
  const auto stage = input.monitor().stage("solve");
  if (const auto errors = poisson_errors(elements, system, feet)) {
    output.set("poisson_max", errors->max);
    output.set("poisson_l2", errors->l2);
    std::vector<double> at_vertices(input.mesh().vertices.size(), 0.0);
    for (std::size_t i = 0; i < elements.vertex.size(); ++i) {
      at_vertices[elements.vertex[i]] = errors->at_unknowns[static_cast<Eigen::Index>(i)];
    }
    output.add_vertex_data("poisson_error", std::move(at_vertices));
  }
}

std::string largest_nodal_error(const Measurement& m) { return fmt::format("largest {:.2g}", m.number("poisson_max")); }

std::string largest_gradient_error(const Measurement& m) {
  return fmt::format("largest {:.2g}", m.number("gradient_max"));
}

std::vector<FieldDeclaration> fields() {
  return {
      {.name = "poisson_error",
       .title = "the error of a solution of Poisson's equation",
       .legend = "error",
       .explanation =
           "Absolute error at the vertices, over the root mean square of the solution (poisson_max): the first method "
           "beside the worst. Colours are logarithmic.",
       .scale = FieldScale::logarithmic,
       .runs = FieldRuns::first_and_worst,
       .judged_by = "poisson_max",
       .caption = largest_nodal_error},
      {.name = "gradient_error",
       .title = "the error of gradients",
       .legend = "error",
       .explanation = "Error of the gradient of a function that is interpolated in each triangle, over the root "
                      "mean square of the true gradient (gradient_max): the first method beside the worst. Colours are "
                      "logarithmic.",
       .scale = FieldScale::logarithmic,
       .runs = FieldRuns::first_and_worst,
       .judged_by = "gradient_max",
       .caption = largest_gradient_error}};
}

}  // namespace

Metric metric_poisson() {
  const std::string unless = std::string(no_stiffness) +
                             ", it is not closed, an edge has more than two triangles, slivers leave no digits, or no "
                             "point of it could be projected to the surface";
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
       .unmeasured = std::string(no_stiffness) + ", or no point of it could be projected to the surface"}};
  for (FigureDeclaration& figure : metric.figures) figure.better = Better::smaller;
  metric.fields = fields();
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
