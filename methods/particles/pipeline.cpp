#include "isobench/methods/particles/pipeline.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "isobench/foundation/error.h"
#include "isobench/methods/closing/labelled_delaunay.h"
#include "isobench/methods/closing/tight_cocone.h"
#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/particles/cure/cure.h"
#include "isobench/methods/particles/finish/finish.h"
#include "isobench/methods/particles/sampling/biased_population.h"
#include "isobench/methods/particles/sampling/critical_seeds.h"
#include "isobench/methods/particles/sampling/gauss_seidel.h"
#include "isobench/methods/particles/sampling/population.h"
#include "isobench/methods/particles/sampling/relaxation.h"
#include "isobench/methods/particles/sampling/seeds.h"
#include "isobench/methods/sizing/critical_points/critical_points.h"
#include "isobench/methods/sizing/limit.h"

namespace isobench::particles {

namespace {

bool chosen(const MeshingTask& task, const char* stage, const char* name) {
  return task.parameters.text(stage) == name;
}

SizingStages sizing_stages(const MeshingTask& task) {
  SizingStages stages;
  if (task.sizing.uniform()) return stages;
  if (chosen(task, "medial_axis", "foot-points")) {
    stages.medial_axis = MedialAxis::foot_points;
    if (chosen(task, "axis_ends", "curvature-centres")) stages.axis_ends = AxisEnds::curvature_centres;
    stages.axis_halvings = task.parameters.integer("axis_halvings");
  }
  if (chosen(task, "limiter", "iteration")) stages.limiter = Limiter::iteration;
  if (chosen(task, "sizing_nodes", "bounding")) stages.nodes = SizingNodes::bounding;
  return stages;
}

/// The field to mesh by. What the result is measured against is the task's own, whichever stages the method takes.
std::shared_ptr<const SizingField> sizing_field(const MeshingTask& task, Monitor& monitor) {
  if (task.sizing.uniform()) return task.sizing_field(monitor);
  const SizingStages stages = sizing_stages(task);
  const double gradation = task.parameters.number("gradation");
  if (stages == SizingStages{}) {
    auto usual = task.sizing_field(monitor);
    if (!(*task.sizing.delta > gradation)) return usual;
    // Smaller everywhere, so what the asked δ promises holds all the same.
    const auto stage = monitor.stage("sizing");
    const auto limit = monitor.stage("limit");
    return std::make_shared<const SizingField>(usual->band_shared(), usual->h0_nodes(),
                                               limit_gradient(*usual->band(), usual->h0_nodes(), gradation, monitor),
                                               usual->floor_length());
  }
  const auto stage = monitor.stage("sizing");
  return std::make_shared<const SizingField>(make_sizing_field(task.surface, task.sizing, monitor, stages));
}

/// Sizes are divided by g so that the longest edges, too, stay below h0; a uniform length is met on average instead.
double contraction(const MeshingTask& task) {
  const double g = task.parameters.number("contraction");
  return task.sizing.uniform() ? 1.0 : g;
}

/// The δ that is meshed by.
double meshed_delta(const MeshingTask& task) {
  const double most = task.parameters.number("gradation");
  return task.sizing.uniform() ? most : std::min(*task.sizing.delta, most);
}

/// mm
double critical_floor(const MeshingTask& task) {
  return task.parameters.number("critical_floor") * task.surface.voxel();
}

/// Leaves the places where the sizing's floor is larger than the features for someone to look at.
void show_floor_places(const std::vector<CriticalPoint>& points, double floor, double epsilon, double least,
                       Monitor& monitor) {
  std::size_t count = 0;
  std::size_t left = 0;
  Artefact places;
  for (const CriticalPoint& point : points) {
    const double wanted = 2.0 * epsilon * point.distance;
    if (!(wanted < floor)) continue;
    ++count;
    if (wanted < least) ++left;
    places.points.push_back(point.position);
    places.data["distance"].push_back(point.distance);
    places.data["falling"].push_back(point.falling);
  }
  monitor.set("floor/places", static_cast<double>(count));
  monitor.set("floor/places left", static_cast<double>(left));
  if (monitor.keeps_artefacts()) monitor.artefact("floor-places", std::move(places));
}

/// Where the topology is decided by features smaller than the floor, and particles are to stand closer for it.
std::vector<CriticalPoint> places_below_the_floor(const MeshingTask& task, const SizingField& field, Monitor& monitor) {
  if (task.sizing.uniform()) return {};
  const auto stage = monitor.stage("critical points");
  const double epsilon = *task.sizing.epsilon;
  std::vector<CriticalPoint> points =
      critical_points(task.surface, *field.band(), field.floor_length() / (2.0 * epsilon));
  const double least = std::min(field.floor_length(), critical_floor(task));
  show_floor_places(points, field.floor_length(), epsilon, least, monitor);
  if (!(least < field.floor_length())) return {};
  return points;
}

Particles seed(const MeshingTask& task, const Spacing& spacing, const std::vector<CriticalPoint>& below_floor,
               const TriangleMesh& lattice_mesh, Monitor& monitor) {
  std::vector<Eigen::Vector3d> points;
  if (chosen(task, "seeds", "marching-cubes")) {
    points = lattice_seeds(task.surface, lattice_mesh);
  } else {
    const double ideal = task.sizing.vertices.value_or(ideal_count(lattice_mesh, spacing));
    points = eliminate_to_seeds(task.surface, lattice_mesh, spacing, static_cast<std::size_t>(std::llround(ideal)),
                                task.parameters.number("candidates"), task.seed, monitor);
  }
  if (!below_floor.empty()) add_critical_seeds(below_floor, *spacing.finer, task.surface, spacing, task.seed, points);
  monitor.set("particles/seeds", static_cast<double>(points.size()));
  return make_particles(task.surface, spacing, std::move(points));
}

void book(const PopulationChange& change, std::size_t count, Monitor& monitor) {
  monitor.add("particles/split", static_cast<double>(change.split));
  monitor.add("particles/deleted", static_cast<double>(change.deleted));
  monitor.trace("particles", static_cast<double>(count));
}

constexpr std::uint64_t most_rounds = 200;  // never seen to be needed
constexpr double still = 0.01;              // share of particles that still come and go at the end

/// Lattice seeds are as many as the lattice has, not as the sizing asks for, and the few controls of Newton's stage
/// could not make up for that.
void bring_to_number(const MeshingTask& task, const Spacing& spacing, Particles& all, Monitor& monitor) {
  constexpr int sweeps = 5;
  for (std::uint64_t round = 0; round < most_rounds; ++round) {
    relax(task.surface, spacing, all, sweeps, monitor);
    const auto change = control_population_by_bias(task.surface, spacing, all, task.seed, round);
    book(change, all.size(), monitor);
    if (static_cast<double>(change.split + change.deleted) < still * static_cast<double>(all.size())) return;
  }
}

void relax_by_newton(const MeshingTask& task, const Spacing& spacing, Particles& all, Monitor& monitor) {
  if (chosen(task, "seeds", "marching-cubes")) bring_to_number(task, spacing, all, monitor);
  const int sweeps = task.parameters.integer("sweeps");
  const int rounds = task.parameters.integer("rounds");
  // Half of the sweeps between the population controls, half after the last.
  const int between = rounds > 0 ? std::max(1, sweeps / (2 * rounds)) : 0;
  for (int round = 0; round < rounds; ++round) {
    relax(task.surface, spacing, all, between, monitor);
    const auto change = control_population(task.surface, spacing, all, task.parameters.number("split_below"),
                                           task.parameters.number("delete_above"));
    book(change, all.size(), monitor);
  }
  relax(task.surface, spacing, all, std::max(0, sweeps - rounds * between), monitor);
}

void relax_as_published(const MeshingTask& task, const Spacing& spacing, Particles& all, Monitor& monitor) {
  std::uint64_t round = 0;
  for (; round < most_rounds; ++round) {
    relax_in_order(task.surface, spacing, all, monitor);
    const auto count = static_cast<double>(all.size());
    Particles changed = all;
    const auto change = control_population_by_bias(task.surface, spacing, changed, task.seed, round);
    // The last change is not made: what it brings would not be relaxed.
    if (static_cast<double>(change.split + change.deleted) < still * count) break;
    all = std::move(changed);
    book(change, all.size(), monitor);
  }
  monitor.set("particles/rounds", static_cast<double>(round + 1));
  if (round == most_rounds) monitor.note("the population of particles did not settle");
}

void tell_own_h0(const SizingField& field, TriangleMesh& mesh) {
  std::vector<double>& h0 = mesh.vertex_data[own_h0];
  for (const Eigen::Vector3d& x : mesh.vertices) h0.push_back(field.h0(x));
}

void show(const Particles& all, Monitor& monitor) {
  monitor.set("particles/count", static_cast<double>(all.size()));
  if (!monitor.keeps_artefacts()) return;
  monitor.artefact("particles", {all.points, {{"h", all.spacing}, {"energy", energies(all, acting_neighbours(all))}}});
}

void book(const Defects& defects, const std::string& when, Monitor& monitor) {
  monitor.set("cure/pinched " + when, static_cast<double>(defects.pinched));
  monitor.set("cure/isolated " + when, static_cast<double>(defects.isolated));
  monitor.set("cure/tilted " + when, static_cast<double>(defects.tilted));
  monitor.set("cure/crossed " + when, static_cast<double>(defects.crossed));
  monitor.set("cure/lost components " + when, static_cast<double>(defects.lost));
}

std::vector<Triangle> close_labelled(const MeshingTask& task, const Spacing& spacing, SizeBounds& finer,
                                     const TriangleMesh& lattice_mesh, Particles& all, Monitor& monitor) {
  LabelledDelaunay delaunay(all.points, task.surface, monitor);
  const CureLimits limits{task.parameters.integer("cure"), task.parameters.integer("cure_relaxations"),
                          critical_floor(task)};
  if (limits.rounds > 0) {
    const auto stage = monitor.stage("cure");
    const Cure cured = cure(task.surface, spacing, &finer, lattice_mesh, all, delaunay, limits, monitor);
    book(cured.before, "before", monitor);
    book(cured.after, "after", monitor);
    monitor.set("cure/rounds", cured.rounds);
    monitor.set("cure/inserted", static_cast<double>(cured.inserted));
    monitor.set("cure/relaxations", cured.relaxations);
    monitor.set("cure/relaxed", static_cast<double>(cured.relaxed));
    monitor.set("cure/labels changed", static_cast<double>(cured.flipped));
  }
  return delaunay.triangles();
}

TriangleMesh close(const MeshingTask& task, const Spacing& spacing, SizeBounds& finer, const TriangleMesh& lattice_mesh,
                   Particles& all, Monitor& monitor) {
  TriangleMesh result;
  if (chosen(task, "surface", "tight-cocone")) {
    const bool poles = chosen(task, "normals", "poles");
    const TightCocone closed =
        poles ? tight_cocone(all.points, monitor) : tight_cocone(all.points, all.normals, monitor);
    result.triangles = closed.triangles;
    monitor.set("cocone/undersampled", static_cast<double>(closed.undersampled));
    monitor.set("cocone/pruned", static_cast<double>(closed.pruned));
    monitor.set("cocone/bad", static_cast<double>(closed.bad));
    monitor.set("cocone/conflicts", static_cast<double>(closed.conflicts));
    monitor.set("cocone/transparent", static_cast<double>(closed.transparent));
  } else {
    result.triangles = close_labelled(task, spacing, finer, lattice_mesh, all, monitor);
  }
  result.vertices = std::move(all.points);
  monitor.set("particles/unused", static_cast<double>(drop_unused_vertices(result)));
  return result;
}

}  // namespace

TriangleMesh mesh_by_particles(const MeshingTask& task, Monitor& monitor) {
  const auto field = sizing_field(task, monitor);
  const std::vector<CriticalPoint> below_floor = places_below_the_floor(task, *field, monitor);
  SizeBounds finer(task.surface, meshed_delta(task));
  if (!below_floor.empty())
    finer.add(critical_bounds(below_floor, *task.sizing.epsilon, critical_floor(task), task.surface.voxel()));
  const Spacing spacing{*field, contraction(task), &finer};
  TriangleMesh lattice_mesh;
  Particles all;
  {
    const auto stage = monitor.stage("seeds");
    lattice_mesh = marching_cubes(task.surface, monitor);
    all = seed(task, spacing, below_floor, lattice_mesh, monitor);
  }
  {
    const auto stage = monitor.stage("relaxation");
    if (chosen(task, "relaxation", "gauss-seidel"))
      relax_as_published(task, spacing, all, monitor);
    else
      relax_by_newton(task, spacing, all, monitor);
  }
  show(all, monitor);
  TriangleMesh mesh;
  {
    const auto stage = monitor.stage("triangulation");
    mesh = close(task, spacing, finer, lattice_mesh, all, monitor);
  }
  if (const int rounds = task.parameters.integer("finish"); rounds > 0) {
    const auto stage = monitor.stage("finish");
    mesh = finish(task.surface, *field, mesh, rounds, monitor);
  }
  if (sizing_stages(task) != SizingStages{}) tell_own_h0(*field, mesh);
  return mesh;
}

}  // namespace isobench::particles
