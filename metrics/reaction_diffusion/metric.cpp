#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "isobench/metrics/metric_input.h"
#include "isobench/metrics/reaction_diffusion/reaction_diffusion.h"
#include "isobench/metrics/reaction_diffusion/surface_area.h"

namespace isobench {
namespace {

constexpr double safety = 0.9;           // of the longest stable step, as simulations use it
constexpr double good_step_factor = 12;  // twice that of a lattice of equilateral triangles
constexpr double spots_per_radius = 10;  // enough for a pattern, and fine meshes still need few steps
/// A simulation with more work is not done: eight seconds on two cores, enough for a good mesh of 250,000 vertices. A
/// step's work is its vertices, and as many as this for a pass of all threads over none.
constexpr double most_work = 1.4e9;
constexpr double work_of_a_pass = 10000;

/// What the simulations on a mesh have in common.
struct Simulations {
  const FiniteElements& elements;
  SpotPattern pattern;
  Concentrations first;

  double steps_of(double step) const { return std::ceil(SpotPattern::duration / step); }
  double most_steps() const { return std::floor(most_work / (static_cast<double>(elements.size()) + work_of_a_pass)); }
};

/// `row`: 0 for u, 1 for v.
std::vector<double> at_vertices(const MetricInput& input, const FiniteElements& elements, const Concentrations& c,
                                Eigen::Index row) {
  std::vector<double> values(input.mesh().vertices.size(), 0.0);
  for (Eigen::Index i = 0; i < elements.size(); ++i) values[elements.vertex[static_cast<std::size_t>(i)]] = c(row, i);
  return values;
}

/// With the longest stable step of the mesh.
void form_spots(MetricInput& input, MetricOutput& output, const Simulations& simulations, double eigenvalue) {
  const double step = safety * simulations.pattern.largest_step(eigenvalue);
  const double steps = simulations.steps_of(step);
  const bool is_done = steps <= simulations.most_steps();
  output.set("pattern_steps", steps);
  output.set("pattern_steps_done", is_done ? steps : 0.0);
  if (!is_done) return;
  const auto stage = input.monitor().stage("spots");
  const March end = march(simulations.elements, simulations.pattern, simulations.first, step,
                          static_cast<std::size_t>(steps), input.monitor());
  output.add_vertex_data("spots", at_vertices(input, simulations.elements, end.concentrations, 0));
}

/// With the step that suits a good mesh with edges of this length, where this mesh's own longest step is shorter.
void look_for_blow_up(MetricInput& input, MetricOutput& output, const Simulations& simulations, double smallest_h) {
  const double step = safety * simulations.pattern.largest_step(good_step_factor / (smallest_h * smallest_h));
  const double steps = simulations.steps_of(step);
  const auto stage = input.monitor().stage("blow_up");
  const March end = march(simulations.elements, simulations.pattern, simulations.first, step,
                          static_cast<std::size_t>(std::min(steps, simulations.most_steps())), input.monitor());
  const auto done = static_cast<double>(end.steps);
  if (!end.blew_up && done < steps) return;
  output.set("pattern_stable_percent", end.blew_up ? 100.0 * (done - 1.0) / steps : 100.0);
  if (!end.blew_up) return;
  const std::uint32_t vertex = simulations.elements.vertex[static_cast<std::size_t>(end.worst)];
  const Eigen::Vector3d place = input.surface().lattice().to_world(input.mesh().vertices[vertex]);
  output.set("blow_up_step", done);
  output.set("blow_up_x", place.x());
  output.set("blow_up_y", place.y());
  output.set("blow_up_z", place.z());
  // v spreads faster than u, so it blows up first.
  output.add_vertex_data("blow_up", at_vertices(input, simulations.elements, end.concentrations, 1));
}

void measure(MetricInput& input, MetricOutput& output) {
  const FiniteElements& elements = input.finite_elements();
  if (!elements.regular) return;
  const std::optional<double> factor = input.uniform_step_factor();
  const double area = surface_area(input.surface());
  if (!factor || !(area > 0.0)) return;
  const SpotPattern pattern{std::sqrt(area / (4.0 * std::numbers::pi)) / spots_per_radius};
  std::vector<Eigen::Vector3d> points;
  for (const std::uint32_t v : elements.vertex) points.push_back(input.mesh().vertices[v]);
  const Simulations simulations{elements, pattern, first_concentrations(points, pattern)};
  const double eigenvalue = *factor / elements.mean_squared_edge();
  form_spots(input, output, simulations, eigenvalue);
  const double smallest_h = input.is_adaptive()
                                ? asked_lengths(elements, input.mesh(), input.sizing_if_given()).minCoeff()
                                : std::sqrt(elements.mean_squared_edge());
  if (eigenvalue * smallest_h * smallest_h <= good_step_factor)
    output.set("pattern_stable_percent", 100.0);
  else
    look_for_blow_up(input, output, simulations, smallest_h);
}

std::string caption_of_spots(const Measurement& m) {
  const double steps = m.number("pattern_steps");
  if (m.number("pattern_steps_done") > 0.0) return fmt::format("{:.0f} steps", steps);
  if (m.figure("pattern_steps"))
    return (steps < 1e6 ? fmt::format("needs {:.0f} steps", steps)
                        : fmt::format("needs {:.3g} million steps", steps / 1e6)) +
           ": too many, not done";
  return "not done: " + declared_figure("pattern_steps").unmeasured;
}

std::string caption_of_blow_up(const Measurement& m) {
  return fmt::format("blows up in step {:.0f}, after {:.2g} % of the time, at ({:.1f}, {:.1f}, {:.1f}) mm",
                     m.number("blow_up_step"), m.number("pattern_stable_percent"), m.number("blow_up_x"),
                     m.number("blow_up_y"), m.number("blow_up_z"));
}

std::vector<FigureDeclaration> figures() {
  std::vector<FigureDeclaration> all = {
      {.name = "pattern_steps",
       .definition =
           "Explicit steps that a simulation needs on the mesh: two substances react and spread from a fixed "
           "start until their spots are there (Schnakenberg's reaction, time 24, linear finite elements with "
           "lumped mass). The spots are L/10 apart, where L² is the area of F = c over 4π: simulated time and "
           "lengths are the surface's. A step is 0.9 of the longest that is stable.",
       .kind = Kind::count,
       .better = Better::smaller},
      {.name = "pattern_steps_done",
       .definition = "Steps of pattern_steps that were done: all, or 0 if steps × (vertices + 10,000) is above 1.4e9.",
       .kind = Kind::count},
      {.name = "pattern_stable_percent",
       .unit = "%",
       .definition =
           "Share of the simulated time of pattern_steps before a concentration passes 100, if the step is that of "
           "a good mesh: 0.9 of the longest that is stable at a step_factor of 12, twice that of equilateral "
           "triangles. For their h² stands (4/√3) times the mean area of a triangle, or with an adaptive sizing the "
           "smallest square of the sizes that step_factor is measured by. 100 if it does not blow up.",
       .better = Better::larger},
      {.name = "blow_up_step",
       .definition = "Number of the step in which the simulation of pattern_stable_percent blows up.",
       .kind = Kind::count,
       .better = Better::larger}};
  for (const char* axis : {"x", "y", "z"}) {
    all.push_back(
        {.name = std::string("blow_up_") + axis,
         .unit = "mm",
         .definition = fmt::format("Coordinate {} of the vertex with the largest concentration in blow_up_step, "
                                   "in the frame of mesh.vtp.",
                                   axis),
         .column = no_column});
  }
  for (FigureDeclaration& figure : all) {
    figure.unmeasured = no_stiffness;
    if (figure.name.starts_with("blow_up")) figure.unmeasured += ", or the simulation does not blow up";
  }
  return all;
}

}  // namespace

Metric metric_reaction_diffusion() {
  Metric metric;
  metric.name = "reaction_diffusion";
  metric.when = When::on_request;
  metric.needs = Needs::surface;
  metric.figures = figures();
  metric.fields = {
      {.name = "spots",
       .title = "a pattern that forms on the mesh",
       .legend = "u",
       .explanation =
           "Two substances react and spread until spots are there (Schnakenberg 1979), by explicit steps. "
           "Colours show the concentration u. Every mesh has the same start, the same simulated time and its own "
           "longest stable step. A red "
           "point marks where the mesh blows up with the step of a good mesh, also if that is on the far side.",
       .brightest = 3.0,
       .judged_by = "pattern_steps",
       .mark = "blow_up",
       .stage = "measure/reaction_diffusion/spots",
       .caption = caption_of_spots},
      {.name = "blow_up",
       .title = "where the same simulation blows up, close up",
       .legend = "v",
       .explanation = "With the step of a good mesh of the same edge length. The moment at which a "
                      "concentration v passes 100; elsewhere it is below 2.",
       .brightest = 2.0,
       .view = FieldView::mark,
       .mark = "blow_up",
       .caption = caption_of_blow_up}};
  metric.measure = measure;
  return metric;
}

}  // namespace isobench
