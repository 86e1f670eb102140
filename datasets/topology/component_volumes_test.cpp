#include "isobench/datasets/topology/component_volumes.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace isobench {
namespace {

double ball(double radius) { return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius; }

/// A ball of 9 mm with a cavity of 3 mm in its middle, beside a ball of 2 mm; samples at 48 × 32 × 32 nodes.
Isosurface islands(const Eigen::Vector3d& spacing) {
  FloatVolume volume;
  volume.lattice.size = {48, 32, 32};
  volume.lattice.spacing = spacing;
  for (int k = 0; k < 32; ++k) {
    for (int j = 0; j < 32; ++j) {
      for (int i = 0; i < 48; ++i) {
        const Eigen::Vector3d x = spacing.cwiseProduct(Eigen::Vector3d(i, j, k));
        const double r = (x - 15.5 * spacing).norm();
        const double small = 2.0 - (x - spacing.cwiseProduct(Eigen::Vector3d(38.2, 15.1, 15.3))).norm();
        volume.samples.push_back(static_cast<float>(std::max(std::min(9.0 - r, r - 3.0), small)));
      }
    }
  }
  return {std::move(volume), 0.0, Inside::above, Kernel::interpolating_bspline};
}

TEST(ComponentVolumes, AreThoseOfBallsAndOfACavity) {
  for (const Eigen::Vector3d& spacing : {Eigen::Vector3d(1.0, 1.0, 1.0), Eigen::Vector3d(0.7, 0.9, 1.3)}) {
    const Isosurface surface = islands(spacing);
    Monitor monitor;
    const CertifiedTopology topology = certified_topology(surface, monitor);
    std::vector<double> volumes = component_volumes(surface, topology);
    ASSERT_EQ(volumes.size(), 3U);
    std::sort(volumes.begin(), volumes.end());
    EXPECT_NEAR(volumes[0], -ball(3.0), 0.03 * ball(3.0));
    EXPECT_NEAR(volumes[1], ball(2.0), 0.05 * ball(2.0));
    EXPECT_NEAR(volumes[2], ball(9.0), 0.01 * ball(9.0));
  }
}

TEST(ComponentVolumes, SmallOnesAreLeftOutIslandsAndCavitiesAlike) {
  const Isosurface surface = islands({1.0, 1.0, 1.0});
  Monitor monitor;
  CertifiedTopology topology = certified_topology(surface, monitor);
  const std::vector<double> volumes = component_volumes(surface, topology);
  EXPECT_EQ(topology.euler, 6);
  EXPECT_EQ(leave_out_below(ball(1.5), volumes, topology), 0U);
  EXPECT_EQ(leave_out_below(ball(2.5), volumes, topology), 1U);
  EXPECT_EQ(topology.euler, 4);
  EXPECT_EQ(leave_out_below(ball(3.5), volumes, topology), 1U);
  EXPECT_EQ(topology.euler, 2);
  EXPECT_EQ(topology.kept_components(), 1U);
}

TEST(ComponentVolumes, OfASpeckBetweenNodes) {
  // F is a product of three bumps; near its maximum it is 1 − |x|²/2 · curvature.
  FloatVolume volume;
  volume.lattice.size = {10, 9, 9};
  volume.samples.assign(volume.lattice.nodes(), 0.0F);
  volume.at(4, 4, 4) = volume.at(5, 4, 4) = 1.0F;
  const Eigen::Vector3d top(4.5, 4.0, 4.0);
  const double height = Isosurface(volume, 0.3).value(top) + 0.3;
  const double depth = 0.001;
  const Isosurface surface(volume, height - depth);
  Monitor monitor;
  const CertifiedTopology topology = certified_topology(surface, monitor);
  const std::vector<double> volumes = component_volumes(surface, topology);
  ASSERT_EQ(volumes.size(), 1U);
  // The ellipsoid of the quadratic part: semi-axes √(2 depth/|eigenvalue|).
  const double product = -surface.jet(top).hessian.determinant();
  const double expected = 4.0 / 3.0 * std::numbers::pi * std::pow(2.0 * depth, 1.5) / std::sqrt(product);
  EXPECT_NEAR(volumes[0], expected, 0.05 * expected);
}

}  // namespace
}  // namespace isobench
