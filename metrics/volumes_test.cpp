// What `particles` must reach on the four real volumes, at the paper's ε and δ.

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "datasets/catalogue.h"
#include "methods/method.h"
#include "metrics/measurement.h"

namespace isobench {
namespace {

struct Case {
  const char* dataset;
  double epsilon;
  double delta;
};

class ParticlesOnVolumesSlow : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    if (std::getenv("ISOBENCH_DATA") == nullptr) {
      GTEST_SKIP() << "needs the real volumes: set ISOBENCH_DATA to the folder that holds them";
    }
  }
};

TEST_P(ParticlesOnVolumesSlow, ReachThePapersRegime) {
  Monitor monitor;
  const Dataset dataset = load_dataset(GetParam().dataset, monitor);
  SizingRequest sizing;
  sizing.epsilon = GetParam().epsilon;
  sizing.delta = GetParam().delta;
  const Method& particles = method("particles");
  const MeshingTask task(*dataset.surface, sizing, Parameters(particles.parameters), 1);
  TriangleMesh mesh = particles.mesh(task, monitor);
  const Measurement found = measure(mesh, *dataset.surface, *task.sizing_field(monitor), 1, monitor);

  EXPECT_EQ(found.topology.boundary_edges, 0U);
  EXPECT_GE(found.radius_ratio.avg, 0.94);
  EXPECT_GE(found.valence.v6_percent, 63.0);
  EXPECT_LE(found.edges.exceed_percent, 0.5);
  // Newton stops at 1e-6 voxel.
  EXPECT_LE(found.distance.vertex_max, 1e-5 * dataset.surface->voxel());
  if (dataset.name == "pelvis") {
    for (const int k : {1, 2, 3}) {
      const ReferenceTopology reference = reference_topology(*dataset.surface, k, monitor);
      EXPECT_EQ(reference.euler, -14) << "at k = " << k;
      EXPECT_EQ(reference.components, 1U) << "at k = " << k;
    }
    EXPECT_EQ(found.topology.euler, -14);
    EXPECT_EQ(found.topology.components, 1U);
  }
}

INSTANTIATE_TEST_SUITE_P(Paper, ParticlesOnVolumesSlow,
                         testing::Values(Case{"brain", 0.5, 0.3}, Case{"pelvis", 0.75, 0.5}, Case{"skull", 0.5, 0.3},
                                         Case{"vessel", 0.5, 0.3}),
                         [](const auto& chosen) { return std::string(chosen.param.dataset); });

}  // namespace
}  // namespace isobench
