#include "isobench/methods/particles/sizing_stage.h"

#include <algorithm>

#include "isobench/methods/particles/sampling/critical_seeds.h"
#include "isobench/methods/sizing/limit.h"

namespace isobench::particles {

namespace {

SizingStages sizing_stages(const MeshingTask& task) {
  SizingStages stages;
  if (task.sizing.uniform()) return stages;
  const Parameters& chosen = task.parameters;
  if (chosen.text("medial_axis") == "foot-points") {
    stages.medial_axis = MedialAxis::foot_points;
    if (chosen.text("axis_ends") == "curvature-centres") stages.axis_ends = AxisEnds::curvature_centres;
    stages.axis_halvings = chosen.integer("axis_halvings");
  }
  if (chosen.text("limiter") == "iteration") stages.limiter = Limiter::iteration;
  if (chosen.text("sizing_nodes") == "bounding") stages.nodes = SizingNodes::bounding;
  return stages;
}

/// The task's field with its gradient limited to `delta` instead of the δ that was asked for.
std::shared_ptr<const SizingField> limited_further(const SizingField& field, double delta, Monitor& monitor) {
  const auto stage = monitor.stage("sizing");
  const auto limit = monitor.stage("limit");
  return std::make_shared<const SizingField>(field.band_shared(), field.h0_nodes(),
                                             limit_gradient(*field.band(), field.h0_nodes(), delta, monitor),
                                             field.floor_length());
}

/// Records the critical points where the h of equation 1 is below the sizing's floor, and for how many of them it is
/// also below `least_h`.
void record_floor_places(const std::vector<CriticalPoint>& points, double floor, double epsilon, double least_h,
                         Monitor& monitor) {
  std::size_t count = 0;
  std::size_t left = 0;
  Artefact places;
  for (const CriticalPoint& point : points) {
    const double wanted = 2.0 * epsilon * point.distance;
    if (!(wanted < floor)) continue;
    ++count;
    if (wanted < least_h) ++left;
    places.points.push_back(point.position);
    places.data["distance"].push_back(point.distance);
    places.data["falling"].push_back(point.falling);
  }
  monitor.set("floor/places", static_cast<double>(count));
  monitor.set("floor/places left", static_cast<double>(left));
  if (monitor.keeps_artefacts()) monitor.artefact("floor-places", std::move(places));
}

/// g. Adaptive spacing is h/g, so that even the longest edges stay below h0; a uniform length is met on average.
double contraction(const MeshingTask& task) {
  return task.sizing.uniform() ? 1.0 : task.parameters.number("contraction");
}

/// The δ that particles follow: the one asked for, but at most `gradation`.
double followed_delta(const MeshingTask& task) {
  const double gradation = task.parameters.number("gradation");
  return task.sizing.uniform() ? gradation : std::min(*task.sizing.delta, gradation);
}

}  // namespace

bool has_own_sizing(const MeshingTask& task) { return sizing_stages(task) != SizingStages{}; }

std::shared_ptr<const SizingField> follow_sizing(const MeshingTask& task, Monitor& monitor) {
  if (has_own_sizing(task)) {
    const auto stage = monitor.stage("sizing");
    auto own =
        std::make_shared<const SizingField>(make_sizing_field(task.surface, task.sizing, monitor, sizing_stages(task)));
    if (task.when_sized) task.when_sized(*own);
    return own;
  }
  auto field = task.sizing_field(monitor);
  // Limiting further makes h smaller, so the gradient stays below the δ that was asked for.
  const double gradation = task.parameters.number("gradation");
  const bool is_steeper = !task.sizing.uniform() && *task.sizing.delta > gradation;
  return is_steeper ? limited_further(*field, gradation, monitor) : field;
}

double critical_floor(const MeshingTask& task) {
  return task.parameters.number("critical_floor") * task.surface.voxel();
}

std::vector<CriticalPoint> critical_points_below_floor(const MeshingTask& task, const SizingField& field,
                                                       Monitor& monitor) {
  if (task.sizing.uniform()) return {};
  const auto stage = monitor.stage("critical points");
  const double epsilon = *task.sizing.epsilon;
  std::vector<CriticalPoint> points =
      critical_points(task.surface, *field.band(), field.floor_length() / (2.0 * epsilon));
  const double least_h = std::min(field.floor_length(), critical_floor(task));
  record_floor_places(points, field.floor_length(), epsilon, least_h, monitor);
  if (!(least_h < field.floor_length())) return {};
  return points;
}

SizedSurface size_surface(const MeshingTask& task, const SizingField& field,
                          const std::vector<CriticalPoint>& below_floor) {
  SizedSurface sized(task.surface, field, contraction(task), followed_delta(task));
  if (!below_floor.empty()) {
    sized.add_bounds(critical_bounds(below_floor, *task.sizing.epsilon, critical_floor(task), task.surface.voxel()));
  }
  return sized;
}

}  // namespace isobench::particles
