#include "isobench/methods/particles/pipeline.h"

#include <utility>
#include <vector>

#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/particles/closing_stage.h"
#include "isobench/methods/particles/finish/finish.h"
#include "isobench/methods/particles/sampling_stages.h"
#include "isobench/methods/particles/sizing_stage.h"

namespace isobench::particles {

namespace {

void record_particles(const Particles& particles, Monitor& monitor) {
  monitor.set("particles/count", static_cast<double>(particles.size()));
  if (!monitor.keeps_artefacts()) return;
  monitor.artefact(
      "particles",
      {particles.points, {{"h", particles.spacing}, {"energy", energies(particles, acting_neighbours(particles))}}});
}

void store_own_h0(const SizingField& field, TriangleMesh& mesh) {
  std::vector<double>& h0 = mesh.vertex_data[own_h0];
  for (const Eigen::Vector3d& x : mesh.vertices) h0.push_back(field.h0(x));
}

}  // namespace

TriangleMesh mesh_by_particles(const MeshingTask& task, Monitor& monitor) {
  const auto field = follow_sizing(task, monitor);
  const std::vector<CriticalPoint> below_floor = critical_points_below_floor(task, *field, monitor);
  SizedSurface sized = size_surface(task, *field, below_floor);
  TriangleMesh lattice_mesh;
  Particles particles;
  {
    const auto stage = monitor.stage("seeds");
    lattice_mesh = marching_cubes(task.surface, monitor);
    particles = seed_particles(task, sized, lattice_mesh, below_floor, monitor);
  }
  {
    const auto stage = monitor.stage("relaxation");
    relax_particles(task, sized, particles, monitor);
  }
  record_particles(particles, monitor);
  TriangleMesh mesh;
  {
    const auto stage = monitor.stage("triangulation");
    mesh = close_particles(task, sized, std::move(particles), monitor);
  }
  if (const int rounds = task.parameters.integer("finish"); rounds > 0) {
    const auto stage = monitor.stage("finish");
    const FinishOptions options{rounds, task.parameters.number("area_weight"), task.parameters.number("easing")};
    mesh = finish(sized, mesh, options, monitor);
  }
  if (has_own_sizing(task)) store_own_h0(*field, mesh);
  return mesh;
}

}  // namespace isobench::particles
