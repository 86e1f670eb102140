#include <benchmark/benchmark.h>

#include <random>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/datasets/phantoms/phantoms.h"

namespace isobench {
namespace {

const Isosurface& surface() {
  static const Isosurface gyroid(sample_phantom(phantom("gyroid-ball"), 128), 0.0);
  return gyroid;
}

/// Points near the surface, one neighbour after another, which is the order in which methods evaluate them.
const std::vector<Eigen::Vector3d>& points() {
  static const std::vector<Eigen::Vector3d> near = [] {
    std::vector<Eigen::Vector3d> result;
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const Eigen::Vector3d& spacing = surface().lattice().spacing;
    const auto& size = surface().lattice().size;
    std::vector<float> slab;
    for (int k = 1; k + 1 < size[2]; ++k) {
      surface().node_values(k, slab);
      for (int j = 1; j + 1 < size[1]; ++j) {
        for (int i = 1; i + 1 < size[0]; ++i) {
          if (std::abs(slab[surface().lattice().index(i, j, 0)]) > 0.5 * surface().voxel()) continue;
          result.push_back(spacing.cwiseProduct(Eigen::Vector3d(i + unit(random), j + unit(random), k + unit(random))));
        }
      }
    }
    return result;
  }();
  return near;
}

template <typename Evaluate>
void at_all_points(benchmark::State& state, Evaluate&& evaluate) {
  std::size_t n = 0;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(evaluate(points()[n]));
    if (++n == points().size()) n = 0;
  }
}

void value(benchmark::State& state) {
  at_all_points(state, [](const Eigen::Vector3d& x) { return surface().value(x); });
}
void value_gradient(benchmark::State& state) {
  at_all_points(state, [](const Eigen::Vector3d& x) { return surface().value_gradient(x); });
}
void jet(benchmark::State& state) {
  at_all_points(state, [](const Eigen::Vector3d& x) { return surface().jet(x); });
}
void project(benchmark::State& state) {
  at_all_points(state, [](const Eigen::Vector3d& x) { return surface().project(x); });
}
void node_values(benchmark::State& state) {
  std::vector<float> slab;
  for ([[maybe_unused]] auto _ : state) surface().node_values(60, slab);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(slab.size()));
}

BENCHMARK(value)->Name("Isosurface/value");
BENCHMARK(value_gradient)->Name("Isosurface/value_gradient");
BENCHMARK(jet)->Name("Isosurface/jet");
BENCHMARK(project)->Name("Isosurface/project");
BENCHMARK(node_values)->Name("Isosurface/node_values");

}  // namespace
}  // namespace isobench
