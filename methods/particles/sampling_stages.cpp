#include "isobench/methods/particles/sampling_stages.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "isobench/methods/particles/relaxation/biased_population_control.h"
#include "isobench/methods/particles/relaxation/gauss_seidel.h"
#include "isobench/methods/particles/relaxation/newton.h"
#include "isobench/methods/particles/sampling/component_seeds.h"
#include "isobench/methods/particles/sampling/critical_seeds.h"
#include "isobench/methods/particles/sampling/seeds.h"

namespace isobench::particles {

namespace {

constexpr std::uint64_t most_rounds = 200;  // more than any volume has needed
constexpr double settled_share = 0.01;      // the population has settled when a round changes fewer particles
constexpr const char* from_lattice = "marching-cubes";

bool has_settled(const PopulationChange& change, std::size_t count) {
  return static_cast<double>(change.split + change.deleted) < settled_share * static_cast<double>(count);
}

void record_change(const PopulationChange& change, std::size_t count, Monitor& monitor) {
  monitor.add("particles/split", static_cast<double>(change.split));
  monitor.add("particles/deleted", static_cast<double>(change.deleted));
  monitor.trace("particles", static_cast<double>(count));
}

/// Brings the number of particles near the ideal one. The number of lattice seeds depends on the lattice instead of the
/// sizing, and the few population controls of the newton relaxation cannot correct it.
void approach_ideal_count(const MeshingTask& task, const SizedSurface& sized, Particles& particles, Monitor& monitor) {
  constexpr int sweeps = 5;
  for (std::uint64_t round = 0; round < most_rounds; ++round) {
    relax_by_newton(sized, particles, sweeps, monitor);
    const auto change = control_population_by_bias(sized, particles, task.seed, round);
    record_change(change, particles.size(), monitor);
    if (has_settled(change, particles.size())) return;
  }
}

void newton_with_controls(const MeshingTask& task, const SizedSurface& sized, Particles& particles, Monitor& monitor) {
  const int sweeps = task.parameters.integer("sweeps");
  const int rounds = task.parameters.integer("rounds");
  const PopulationLimits limits = population_limits(task);
  // Half of the sweeps come before the last population control, half after it.
  const int between = rounds > 0 ? std::max(1, sweeps / (2 * rounds)) : 0;
  for (int round = 0; round < rounds; ++round) {
    relax_by_newton(sized, particles, between, monitor);
    const auto change = control_population(sized, particles, limits);
    record_change(change, particles.size(), monitor);
  }
  relax_by_newton(sized, particles, std::max(0, sweeps - rounds * between), monitor);
}

/// Alternates relaxation and population control until the number of particles settles, as published.
void gauss_seidel_with_controls(const MeshingTask& task, const SizedSurface& sized, Particles& particles,
                                Monitor& monitor) {
  std::uint64_t round = 0;
  for (; round < most_rounds; ++round) {
    relax_by_gauss_seidel(sized, particles, monitor);
    Particles changed = particles;
    const auto change = control_population_by_bias(sized, changed, task.seed, round);
    // The last change is dropped, because no relaxation would follow it.
    if (has_settled(change, particles.size())) break;
    particles = std::move(changed);
    record_change(change, particles.size(), monitor);
  }
  monitor.set("particles/rounds", static_cast<double>(round + 1));
  if (round == most_rounds) monitor.note("the population of particles did not settle");
}

}  // namespace

PopulationLimits population_limits(const MeshingTask& task) {
  return {task.parameters.number("split_below"), task.parameters.number("delete_above")};
}

Particles seed_particles(const MeshingTask& task, SizedSurface& sized, const TriangleMesh& lattice_mesh,
                         const std::vector<CriticalPoint>& below_floor, Monitor& monitor) {
  std::vector<Eigen::Vector3d> points;
  if (task.parameters.text("seeds") == from_lattice) {
    points = lattice_seeds(task.surface, lattice_mesh);
  } else {
    const double ideal = task.sizing.vertices.value_or(ideal_count(sized, lattice_mesh));
    points = eliminate_to_seeds(sized, lattice_mesh, static_cast<std::size_t>(std::llround(ideal)),
                                task.parameters.number("candidates"), task.seed, monitor);
  }
  if (!below_floor.empty()) add_critical_seeds(below_floor, sized, task.seed, points);
  if (task.parameters.integer("cure") > 0) {
    const std::size_t small = add_component_seeds(task.topology(monitor), sized, points);
    monitor.set("particles/small components", static_cast<double>(small));
  }
  monitor.set("particles/seeds", static_cast<double>(points.size()));
  return make_particles(sized, std::move(points));
}

void relax_particles(const MeshingTask& task, const SizedSurface& sized, Particles& particles, Monitor& monitor) {
  if (task.parameters.text("relaxation") == "gauss-seidel") {
    gauss_seidel_with_controls(task, sized, particles, monitor);
    return;
  }
  if (task.parameters.text("seeds") == from_lattice) approach_ideal_count(task, sized, particles, monitor);
  newton_with_controls(task, sized, particles, monitor);
}

}  // namespace isobench::particles
