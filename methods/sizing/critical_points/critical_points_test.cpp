// Functions with known critical points: a sum of cosines, and two spheres that nearly touch.
#include "isobench/methods/sizing/critical_points/critical_points.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace isobench {
namespace {

Isosurface sampled(int nodes, double spacing, double isovalue, const std::function<double(const Eigen::Vector3d&)>& f) {
  FloatVolume volume;
  volume.lattice.size = {nodes, nodes, nodes};
  volume.lattice.spacing = Eigen::Vector3d::Constant(spacing);
  for (int k = 0; k < nodes; ++k) {
    for (int j = 0; j < nodes; ++j) {
      for (int i = 0; i < nodes; ++i)
        volume.samples.push_back(static_cast<float>(f(spacing * Eigen::Vector3d(i, j, k))));
    }
  }
  return {std::move(volume), isovalue, Inside::above, Kernel::interpolating_bspline};
}

// cos x + cos y + cos z with a period of 16 nodes. A point is critical if every cosine is 1 or −1.
TEST(CriticalPoints, OfCosinesAreFoundWithTheirKinds) {
  constexpr double wave = 2.0 * std::numbers::pi / 16.0;
  const auto f = [](const Eigen::Vector3d& x) {
    return std::cos(wave * x[0]) + std::cos(wave * x[1]) + std::cos(wave * x[2]);
  };
  // Saddles have a sum of −1 or 1, extrema one of −3 or 3. Near c = 0.9, only the saddles with a sum of 1, which have
  // two falling directions, are in reach.
  const Isosurface surface = sampled(33, 1.0, 0.9, f);
  const Band band(surface, 2);
  const double distance = std::sqrt(2.0 * 0.1 / (wave * wave));  // from a point where the sum is 1 to the surface
  const auto found = critical_points(surface, band, 1.5 * distance);
  // The points away from the border: each coordinate is a multiple of half a period, one cosine is −1 and two are 1.
  std::size_t inner = 0;
  for (const CriticalPoint& point : found) {
    const Eigen::Vector3d& x = point.position;
    if ((x.array() < 2.0).any() || (x.array() > 30.0).any()) continue;  // the spline differs from f near the border
    ++inner;
    const Eigen::Vector3d rounded = 8.0 * (x / 8.0).array().round().matrix();
    EXPECT_LT((x - rounded).norm(), 0.01) << x.transpose();
    EXPECT_NEAR(f(rounded), 1.0, 1e-9);
    EXPECT_NEAR(point.value, 0.1, 1e-3);
    EXPECT_EQ(point.falling, 2);
    EXPECT_NEAR(point.distance, distance, 0.01 * distance);
  }
  // The 27 inner points have coordinates of 8, 16 or 24, where the cosine is −1, 1 and −1. At six of them, exactly one
  // cosine is −1.
  EXPECT_EQ(inner, 6U);
}

TEST(CriticalPoints, OfTwoSpheresIsTheSaddleBetweenThem) {
  const Eigen::Vector3d a(10.3, 16.1, 15.8);
  const Eigen::Vector3d b(21.7, 16.1, 15.8);
  const auto f = [&](const Eigen::Vector3d& x) {
    return std::exp(-(x - a).squaredNorm() / 25.0) + std::exp(-(x - b).squaredNorm() / 25.0);
  };
  const double between = f(0.5 * (a + b));
  for (const double off : {-0.002, 0.002}) {
    const Isosurface surface = sampled(32, 0.8, between + off, [&](const Eigen::Vector3d& x) { return f(x / 0.8); });
    const auto found = critical_points(surface, Band(surface, 2), 0.5);
    ASSERT_EQ(found.size(), 1U) << off;
    EXPECT_LT((found[0].position - 0.4 * (a + b)).norm(), 0.02);
    EXPECT_EQ(found[0].falling, 2);
    EXPECT_EQ(found[0].value > 0.0, off < 0.0);
  }
}

TEST(CriticalPoints, AreTheSameForAnyNumberOfThreads) {
  const auto f = [](const Eigen::Vector3d& x) {
    return std::sin(0.7 * x[0]) * std::sin(0.5 * x[1]) + 0.2 * x[2] - 2.0;
  };
  const Isosurface surface = sampled(24, 1.0, 0.1, f);
  const Band band(surface, 2);
  std::vector<CriticalPoint> found[2];
  for (int n = 0; n < 2; ++n) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, n == 0 ? 1 : 4);
    found[n] = critical_points(surface, band, 2.0);
  }
  ASSERT_EQ(found[0].size(), found[1].size());
  for (std::size_t n = 0; n < found[0].size(); ++n) {
    EXPECT_EQ(found[0][n].position, found[1][n].position);
    EXPECT_EQ(found[0][n].distance, found[1][n].distance);
  }
}

}  // namespace
}  // namespace isobench
