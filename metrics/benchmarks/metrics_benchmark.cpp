#include <benchmark/benchmark.h>

#include <cmath>

#include "isobench/datasets/topology/certified_topology.h"
#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/methods/mesh/self_intersections.h"
#include "isobench/metrics/topology/topology.h"

namespace isobench {

namespace {

/// Interwoven tunnels: a surface through every part of a lattice of n³ nodes.
Isosurface gyroid(int n) {
  FloatVolume volume;
  volume.lattice.size = {n, n, n};
  volume.samples.reserve(volume.lattice.nodes());
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const double x = 0.3 * i;
        const double y = 0.3 * j;
        const double z = 0.3 * k;
        volume.samples.push_back(
            static_cast<float>(std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) + std::sin(z) * std::cos(x)));
      }
    }
  }
  return {std::move(volume), 0.0};
}

void count_connectivity(benchmark::State& state) {
  const TriangleMesh mesh = sample_meshes::torus(static_cast<std::uint32_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(measure_connectivity(mesh));
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}
BENCHMARK(count_connectivity)->Arg(100)->Arg(400)->Unit(benchmark::kMillisecond)->UseRealTime();

void find_self_intersections(benchmark::State& state) {
  const TriangleMesh mesh = sample_meshes::torus(static_cast<std::uint32_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(count_self_intersections(mesh));
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}
BENCHMARK(find_self_intersections)->Arg(100)->Arg(400)->Unit(benchmark::kMillisecond)->UseRealTime();

void prove_topology(benchmark::State& state) {
  const Isosurface surface = gyroid(128);
  for (auto _ : state) {
    Monitor monitor;
    benchmark::DoNotOptimize(certified_topology(surface, monitor));
  }
}
BENCHMARK(prove_topology)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

}  // namespace isobench
