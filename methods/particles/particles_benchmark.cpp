// The stages of `particles` at a uniform spacing on a gyroid ball. Items are particles. The Delaunay triangulation of
// the same points serves as the reference for the cost of the other stages.

#include <benchmark/benchmark.h>

#include <algorithm>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/closing/labelled_delaunay.h"
#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/particles/finish/finish.h"
#include "isobench/methods/particles/mesh_edits/shape_energy.h"
#include "isobench/methods/particles/relaxation/newton.h"
#include "isobench/methods/particles/sampling/seeds.h"

namespace isobench::particles {
namespace {

const Isosurface& surface() {
  static const Isosurface made(sample_phantom(phantom("gyroid-ball"), 128), 0.0);
  return made;
}

const TriangleMesh& lattice_mesh() {
  static const TriangleMesh made = [] {
    Monitor monitor;
    return marching_cubes(surface(), monitor);
  }();
  return made;
}

const SizingField& field() {
  static const SizingField made(surface().voxel());
  return made;
}

const SizedSurface& sized() {
  static const SizedSurface made(surface(), field());
  return made;
}

std::vector<Eigen::Vector3d> seeds() {
  Monitor monitor;
  const auto count = static_cast<std::size_t>(ideal_count(sized(), lattice_mesh()));
  return eliminate_to_seeds(sized(), lattice_mesh(), count, 4.0, 1, monitor);
}

const Particles& relaxed() {
  static const Particles made = [] {
    Monitor monitor;
    Particles all = make_particles(sized(), seeds());
    relax_by_newton(sized(), all, 40, monitor);
    return all;
  }();
  return made;
}

void per_particle(benchmark::State& state, std::int64_t times = 1) {
  state.SetItemsProcessed(state.iterations() * times * static_cast<std::int64_t>(relaxed().size()));
}

void sample_elimination(benchmark::State& state) {
  relaxed();  // computed before the clock starts
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(seeds());
  per_particle(state);
}
BENCHMARK(sample_elimination)->Unit(benchmark::kMillisecond)->UseRealTime();

void neighbour_lists(benchmark::State& state) {
  relaxed();  // computed before the clock starts
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(acting_neighbours(relaxed(), 0.2));
  per_particle(state);
}
BENCHMARK(neighbour_lists)->Unit(benchmark::kMillisecond)->UseRealTime();

void ten_relaxation_sweeps(benchmark::State& state) {
  Monitor monitor;
  relaxed();
  for ([[maybe_unused]] auto _ : state) {
    Particles all = relaxed();
    relax_by_newton(sized(), all, 10, monitor);
    benchmark::DoNotOptimize(all);
  }
  per_particle(state, 10);
}
BENCHMARK(ten_relaxation_sweeps)->Unit(benchmark::kMillisecond)->UseRealTime();

void delaunay_triangulation_labelled(benchmark::State& state) {
  Monitor monitor;
  relaxed();
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(LabelledDelaunay(relaxed().points, surface(), monitor).triangles());
  per_particle(state);
}
BENCHMARK(delaunay_triangulation_labelled)->Unit(benchmark::kMillisecond)->UseRealTime();

void finish_of_the_mesh(benchmark::State& state) {
  Monitor monitor;
  const TriangleMesh closed{
      relaxed().points, LabelledDelaunay(relaxed().points, surface(), monitor).triangles(), {}, {}};
  TriangleMesh mesh;
  for ([[maybe_unused]] auto _ : state) {
    mesh = finish(sized(), closed, {.rounds = 12}, monitor);
    benchmark::DoNotOptimize(mesh);
  }
  double least = 1.0;
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const double q = radius_ratio(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
    least = std::min(least, q);
    sum += q;
  }
  state.counters["least_q"] = least;
  state.counters["mean_q"] = sum / static_cast<double>(mesh.triangles.size());
  per_particle(state);
}
BENCHMARK(finish_of_the_mesh)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace isobench::particles
