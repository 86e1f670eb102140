#include "methods/method.h"

#include <cmath>

#include "methods/labelled_delaunay.h"
#include "methods/marching-cubes/marching_cubes.h"
#include "methods/particles/population.h"
#include "methods/particles/relaxation.h"
#include "methods/particles/seeds.h"

namespace isobench {

namespace {

using particles::Particles;
using particles::Spacing;

/// Sizes are divided by g so that the longest edges, too, stay below h0; a uniform length is met on average instead.
double contraction(const MeshingTask& task) {
  const double g = task.parameters.number("contraction");
  return task.sizing.uniform() ? 1.0 : g;
}

Particles seed(const MeshingTask& task, const Spacing& spacing, Monitor& monitor) {
  const auto stage = monitor.stage("seeds");
  const TriangleMesh lattice_mesh = marching_cubes(task.surface, monitor);
  const double ideal = task.sizing.vertices.value_or(ideal_count(lattice_mesh, spacing));
  const auto count = static_cast<std::size_t>(std::llround(ideal));
  auto points = eliminate_to_seeds(task.surface, lattice_mesh, spacing, count, task.parameters.number("candidates"),
                                   task.seed, monitor);
  monitor.set("particles/seeds", static_cast<double>(points.size()));
  return make_particles(task.surface, spacing, std::move(points));
}

void relax(const MeshingTask& task, const Spacing& spacing, Particles& all, Monitor& monitor) {
  const auto stage = monitor.stage("relaxation");
  const int sweeps = task.parameters.integer("sweeps");
  const int rounds = task.parameters.integer("rounds");
  // Half of the sweeps between the population controls, half after the last.
  const int between = rounds > 0 ? std::max(1, sweeps / (2 * rounds)) : 0;
  for (int round = 0; round < rounds; ++round) {
    particles::relax(task.surface, spacing, all, between, monitor);
    const auto change = control_population(task.surface, spacing, all, task.parameters.number("split_below"),
                                           task.parameters.number("delete_above"));
    monitor.add("particles/split", static_cast<double>(change.split));
    monitor.add("particles/deleted", static_cast<double>(change.deleted));
  }
  particles::relax(task.surface, spacing, all, std::max(0, sweeps - rounds * between), monitor);
}

TriangleMesh mesh(const MeshingTask& task, Monitor& monitor) {
  const auto field = task.sizing_field(monitor);
  const Spacing spacing{*field, contraction(task)};
  Particles all = seed(task, spacing, monitor);
  relax(task, spacing, all, monitor);
  monitor.set("particles/count", static_cast<double>(all.size()));

  const auto stage = monitor.stage("triangulation");
  TriangleMesh result;
  result.triangles = labelled_delaunay(all.points, task.surface, monitor).triangles;
  result.vertices = std::move(all.points);
  monitor.set("particles/unused", static_cast<double>(drop_unused_vertices(result)));
  return result;
}

}  // namespace

Method method_particles() {
  Method method;
  method.name = "particles";
  method.summary =
      "Particles on F = c relaxed to a hexagonal packing under the sizing field, closed by a sign-labelled Delaunay "
      "triangulation (after Meyer, Kirby, Whitaker 2007)";
  method.revision = 1;
  method.parameters = {
      {"contraction",
       1.5,
       "",
       "g: adaptive spacing is h/g, so that even the longest edges stay below h0",
       1.0,
       4.0,
       {},
       false},
      {"candidates",
       4.0,
       "per particle",
       "random candidates from which the seeds are eliminated",
       2.0,
       20.0,
       {},
       false},
      {"sweeps", 60.0, "", "relaxation sweeps in all", 0.0, 10000.0, {}, true},
      {"rounds", 3.0, "", "population controls, spread over the first half of the sweeps", 0.0, 100.0, {}, true},
      {"split_below",
       0.6,
       "ideal energy",
       "a particle with less energy gets a neighbour in its widest gap",
       0.0,
       1.0,
       {},
       false},
      {"delete_above", 1.6, "ideal energy", "a particle with more energy is deleted", 1.0, 100.0, {}, false},
  };
  method.mesh = mesh;
  return method;
}

}  // namespace isobench
