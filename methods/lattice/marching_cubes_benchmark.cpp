#include <benchmark/benchmark.h>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/method.h"

namespace isobench {
namespace {

/// 256³ nodes: about the size of the paper's volumes.
const Isosurface& surface() {
  static const Isosurface gyroid(sample_phantom(phantom("gyroid-ball"), 256), 0.0);
  return gyroid;
}

void run(benchmark::State& state, const char* name) {
  SizingRequest request;
  request.edge_length = 1.0;
  const Method& m = method(name);
  std::size_t triangles = 0;
  surface();
  for ([[maybe_unused]] auto _ : state) {
    Monitor monitor;
    triangles = m.mesh(MeshingTask(surface(), request, Parameters(m.parameters), 1), monitor).triangles.size();
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}

BENCHMARK_CAPTURE(run, marching_cubes, "marching-cubes")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(run, flying_edges, "flying-edges")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace isobench
