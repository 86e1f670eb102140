#include "isobench/methods/particles/sampling/component_seeds.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "isobench/methods/mesh/component_match.h"
#include "isobench/methods/method.h"

namespace isobench {
namespace {

using particles::SizedSurface;

/// A ball of 8 mm, one of 1.2 mm and a speck between nodes, in 32³ nodes 1 mm apart.
Isosurface islands() {
  FloatVolume volume;
  volume.lattice.size = {32, 32, 32};
  for (int k = 0; k < 32; ++k) {
    for (int j = 0; j < 32; ++j) {
      for (int i = 0; i < 32; ++i) {
        const double large = 8.0 - std::hypot(i - 11.5, j - 11.5, k - 11.5);
        const double small = 1.2 - std::hypot(i - 25.3, j - 25.1, k - 24.8);
        volume.samples.push_back(static_cast<float>(std::max({large, small, -1.0})));
      }
    }
  }
  // F of two voxels that are 2.4 above the others is −1 + 0.370 · 2.4 at them, and −1 + 0.426 · 2.4 half-way between.
  volume.at(25, 5, 25) = volume.at(26, 5, 25) = 1.4F;
  return {std::move(volume), 0.0};
}

struct Islands {
  Islands() : surface(islands()), topology(certified_topology(surface, monitor)), field(4.0), sized(surface, field) {}

  Monitor monitor;
  Isosurface surface;
  CertifiedTopology topology;
  SizingField field;
  SizedSurface sized;
};

TEST(ComponentSeeds, GiveEveryComponentEnough) {
  Islands islands;
  ASSERT_EQ(islands.topology.components.size(), 3U);
  std::vector<Eigen::Vector3d> seeds;
  EXPECT_EQ(particles::add_component_seeds(islands.topology, islands.sized, seeds), 3U);
  std::vector<std::size_t> count(3, 0);
  for (const std::uint32_t component : particles::components_at(islands.topology, seeds)) ++count[component];
  for (const std::size_t of_one : count) {
    EXPECT_GE(of_one, 20U);
    EXPECT_LE(of_one, 90U);
  }
  for (const Eigen::Vector3d& x : seeds) EXPECT_NEAR(islands.surface.value(x), 0.0, 1e-5);
  EXPECT_EQ(particles::add_component_seeds(islands.topology, islands.sized, seeds), 0U);
}

TEST(ComponentSeeds, DoNotDependOnThreads) {
  const auto seeds_with = [](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Islands islands;
    std::vector<Eigen::Vector3d> seeds;
    particles::add_component_seeds(islands.topology, islands.sized, seeds);
    return seeds;
  };
  EXPECT_EQ(seeds_with(1), seeds_with(4));
}

TEST(ComponentSeeds, LetParticlesShowIslandsSmallerThanTheEdgesAskedFor) {
  Islands islands;
  for (const char* name : {"particles", "cvt"}) {
    const Method& chosen = method(name);
    SizingRequest sizing;
    sizing.edge_length = 4.0;
    const TriangleMesh mesh =
        chosen.mesh(MeshingTask(islands.surface, sizing, Parameters(chosen.parameters), 1), islands.monitor);
    EXPECT_EQ(match_components(mesh, islands.surface, islands.topology).shown, std::vector<Shown>(3, Shown::right))
        << name;
  }
}

}  // namespace
}  // namespace isobench
