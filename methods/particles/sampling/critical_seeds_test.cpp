#include "isobench/methods/particles/sampling/critical_seeds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "isobench/methods/method.h"

namespace isobench::particles {
namespace {

/// Two balls whose fields nearly join. `off` moves the isovalue away from the value at the saddle between them: below 0
/// there is a bridge, above 0 a gap.
Isosurface dumb_bell(double off) {
  constexpr int nodes = 40;
  const Eigen::Vector3d a(13.2, 19.4, 19.7);
  const Eigen::Vector3d b(26.1, 19.4, 19.7);
  const auto f = [&](const Eigen::Vector3d& x) {
    return std::exp(-(x - a).squaredNorm() / 30.0) + std::exp(-(x - b).squaredNorm() / 30.0);
  };
  FloatVolume volume;
  volume.lattice.size = {nodes, nodes, nodes};
  for (int k = 0; k < nodes; ++k) {
    for (int j = 0; j < nodes; ++j) {
      for (int i = 0; i < nodes; ++i) volume.samples.push_back(static_cast<float>(f(Eigen::Vector3d(i, j, k))));
    }
  }
  return {std::move(volume), f(0.5 * (a + b)) + off, Inside::above, Kernel::interpolating_bspline};
}

long euler_of(const TriangleMesh& mesh) {
  return static_cast<long>(mesh.vertices.size()) - static_cast<long>(mesh.triangles.size()) / 2;
}

// The bridge and the gap are a few hundredths of a voxel wide, far below the sizing's floor. χ is 2 with the bridge
// and 4 with the gap.
TEST(CriticalSeeds, MakeParticlesMeshABridgeThinnerThanTheFloor) {
  for (const double off : {-2e-5, 2e-5}) {
    const Isosurface surface = dumb_bell(off);
    const Method& particles = method("particles");
    SizingRequest sizing;
    sizing.epsilon = 0.5;
    sizing.delta = 0.3;
    Monitor monitor;
    const MeshingTask task(surface, sizing, Parameters(particles.parameters), 1);
    const TriangleMesh mesh = particles.mesh(task, monitor);
    EXPECT_EQ(monitor.counters().at("floor/places"), 1.0);
    EXPECT_EQ(monitor.counters().at("floor/places left"), 0.0);
    EXPECT_EQ(euler_of(mesh), off < 0.0 ? 2 : 4);
    EXPECT_LT(mesh.vertices.size(), 20000U);
  }
}

// Eight spline coefficients around one cell put its middle inside the object although every node is outside.
TEST(CriticalSeeds, ASpeckBetweenTheNodesIsMeshed) {
  constexpr int nodes = 24;
  FloatVolume volume;
  volume.lattice.size = {nodes, nodes, nodes};
  for (int k = 0; k < nodes; ++k) {
    for (int j = 0; j < nodes; ++j) {
      for (int i = 0; i < nodes; ++i) {
        const double ball = 4.0 - (Eigen::Vector3d(i, j, k) - Eigen::Vector3d::Constant(7.0)).norm();
        const bool speck = std::min({i, j, k}) >= 17 && std::max({i, j, k}) <= 18;
        volume.samples.push_back(speck ? 0.45F : static_cast<float>(std::max(-1.0, ball)));
      }
    }
  }
  const Isosurface surface(std::move(volume), 0.0);
  ASSERT_LT(surface.value(Eigen::Vector3d::Constant(17.0)), 0.0);
  ASSERT_GT(surface.value(Eigen::Vector3d::Constant(17.5)), 0.0);
  SizingRequest request;
  request.epsilon = 0.5;
  request.delta = 0.3;
  const Method& particles = method("particles");
  Monitor monitor;
  const TriangleMesh mesh = particles.mesh(MeshingTask(surface, request, Parameters(particles.parameters), 1), monitor);
  EXPECT_EQ(euler_of(mesh), 4);
  std::size_t near = 0;
  for (const Eigen::Vector3d& x : mesh.vertices) near += (x - Eigen::Vector3d::Constant(17.5)).norm() < 1.0 ? 1 : 0;
  EXPECT_GE(near, 12U);
}

}  // namespace
}  // namespace isobench::particles
