// The stages of the sizing field on a gyroid ball. Counters give the time for one sample, ball, node or query.

#include <benchmark/benchmark.h>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/sizing/limit.h"
#include "isobench/methods/sizing/medial_axis/shrinking_balls.h"
#include "isobench/methods/sizing/sizing_field.h"

namespace isobench {
namespace {

const Isosurface& surface() {
  static const Isosurface made(sample_phantom(phantom("gyroid-ball"), 128), 0.0);
  return made;
}

SizingRequest request() {
  SizingRequest asked;
  asked.epsilon = 0.5;
  asked.delta = 0.3;
  return asked;
}

const SurfaceSamples& samples() {
  static const SurfaceSamples made = [] {
    Monitor monitor;
    return surface_samples(surface(), marching_cubes(surface(), monitor).vertices);
  }();
  return made;
}

const SizingField& field() {
  static const SizingField made = [] {
    Monitor monitor;
    return make_sizing_field(surface(), request(), monitor);
  }();
  return made;
}

void per_item(benchmark::State& state, std::size_t items) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(items));
}

void shrinking_balls_of_all_samples(benchmark::State& state) {
  const double cap = 0.5 * surface().extent().minCoeff();
  Monitor monitor;
  samples();  // computed before the clock starts, here and below
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(shrinking_balls(samples(), surface().voxel(), cap, monitor));
  per_item(state, 2 * samples().points.size());
}
BENCHMARK(shrinking_balls_of_all_samples)->Unit(benchmark::kMillisecond)->UseRealTime();

void band_of_the_surface(benchmark::State& state) {
  surface();
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(Band(surface(), 2));
  per_item(state, surface().lattice().nodes());
}
BENCHMARK(band_of_the_surface)->Unit(benchmark::kMillisecond)->UseRealTime();

void limiting_by_fast_iterative(benchmark::State& state) {
  Monitor monitor;
  field();
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(limit_gradient(*field().band(), field().h0_nodes(), 0.3, monitor));
  per_item(state, field().band()->size());
}
BENCHMARK(limiting_by_fast_iterative)->Unit(benchmark::kMillisecond)->UseRealTime();

void asking_for_h(benchmark::State& state) {
  field();
  samples();
  for ([[maybe_unused]] auto _ : state) {
    double sum = 0.0;
    for (const Eigen::Vector3d& x : samples().points) sum += field().h(x);
    benchmark::DoNotOptimize(sum);
  }
  per_item(state, samples().points.size());
}
BENCHMARK(asking_for_h)->Unit(benchmark::kMillisecond)->UseRealTime();

void whole_sizing_field(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    Monitor monitor;
    benchmark::DoNotOptimize(make_sizing_field(surface(), request(), monitor));
  }
  per_item(state, samples().points.size());
}
BENCHMARK(whole_sizing_field)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace isobench
