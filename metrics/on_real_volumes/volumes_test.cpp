// What `particles` must reach on the four real volumes, at the paper's ε and δ.

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/methods/method.h"
#include "isobench/metrics/measurement.h"

namespace isobench {
namespace {

struct VolumeCase {
  const char* dataset;
  double epsilon;
  double delta;
};

void expect_good_triangles(const Measurement& found) {
  EXPECT_EQ(found.number("boundary_edges"), 0.0);
  EXPECT_EQ(found.number("nonmanifold_edges"), 0.0);
  EXPECT_EQ(found.number("nonmanifold_vertices"), 0.0);
  EXPECT_EQ(found.number("self_intersections"), 0.0);
  EXPECT_GE(found.number("angle_min"), 37.0);
  EXPECT_LE(found.number("angle_max"), 88.0);
  EXPECT_EQ(found.number("valence_extreme_count"), 0.0);
}

class OnVolumes : public testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("ISOBENCH_DATA") == nullptr) {
      GTEST_SKIP() << "needs the real volumes: set ISOBENCH_DATA to the folder that holds them";
    }
  }
};

class ParticlesOnVolumes : public OnVolumes, public testing::WithParamInterface<VolumeCase> {};

TEST_P(ParticlesOnVolumes, ReachThePapersRegime) {
  Monitor monitor;
  const Dataset dataset = load_dataset(GetParam().dataset, monitor);
  SizingRequest sizing;
  sizing.epsilon = GetParam().epsilon;
  sizing.delta = GetParam().delta;
  const Method& particles = method("particles");
  const MeshingTask task(*dataset.surface, sizing, Parameters(particles.parameters), 1);
  TriangleMesh mesh = particles.mesh(task, monitor);
  const Measurement found = measure(mesh, *dataset.surface, *task.sizing_field(monitor), monitor);

  expect_good_triangles(found);
  EXPECT_GE(found.number("radius_ratio_min"), 0.84);
  EXPECT_GE(found.number("radius_ratio_avg"), 0.984);
  EXPECT_GE(found.number("valence_6_percent"), 78.0);
  EXPECT_EQ(found.number("edge_over_h0_exceed_count"), 0.0);
  // Newton stops at 1e-6 voxel.
  EXPECT_LE(found.number("distance_vertex_max"), 1e-5 * dataset.surface->voxel());
  EXPECT_EQ(found.number("euler"), found.number("euler_reference"));
  EXPECT_EQ(found.number("components"), found.number("components_reference"));
}

class UniformParticlesOnVolumes : public OnVolumes {};

TEST_F(UniformParticlesOnVolumes, ReachWhatNoPeerDoes) {
  Monitor monitor;
  const Dataset dataset = load_dataset("skull-small", monitor);
  SizingRequest sizing;
  sizing.vertices = 50000.0;
  const Method& particles = method("particles");
  const MeshingTask task(*dataset.surface, sizing, Parameters(particles.parameters), 1);
  TriangleMesh mesh = particles.mesh(task, monitor);
  const Measurement found = measure(mesh, *dataset.surface, *task.sizing_field(monitor), monitor);
  expect_good_triangles(found);
  EXPECT_NEAR(static_cast<double>(mesh.vertices.size()), 50000.0, 500.0);
  EXPECT_GE(found.number("radius_ratio_min"), 0.85);
  EXPECT_GE(found.number("radius_ratio_avg"), 0.99);
  EXPECT_GE(found.number("valence_6_percent"), 86.0);
  // What CGAL's Mesh_3 has at this number of vertices (particles_against_mesh_3).
  EXPECT_LE(found.number("distance_max"), 0.540);
  EXPECT_LE(found.number("distance_from_surface_max"), 0.425);
  EXPECT_EQ(found.number("euler"), 0.0);
  EXPECT_EQ(found.number("components"), 2.0);
}

INSTANTIATE_TEST_SUITE_P(Paper, ParticlesOnVolumes,
                         testing::Values(VolumeCase{"brain", 0.5, 0.3}, VolumeCase{"pelvis", 0.75, 0.5},
                                         VolumeCase{"skull", 0.5, 0.3}, VolumeCase{"vessel", 0.5, 0.3}),
                         [](const auto& chosen) { return std::string(chosen.param.dataset); });

}  // namespace
}  // namespace isobench
