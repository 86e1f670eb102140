#include "isobench/methods/particles/sampling/size_bounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/particles/sampling/critical_seeds.h"

namespace isobench::particles {
namespace {

using Eigen::Vector3d;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double delta = 0.3;

class SizeBoundsTest : public ::testing::Test {
 protected:
  const Isosurface surface{sample_phantom(phantom("sphere"), 40), 0.0};
  const double voxel = surface.voxel();
  const Vector3d middle = 0.5 * surface.extent();
  SizeBounds bounds{surface, delta};
};

TEST_F(SizeBoundsTest, NoneBoundsNothing) {
  EXPECT_EQ(bounds.size(), 0U);
  EXPECT_EQ(bounds.bound(middle), infinite);
  EXPECT_EQ(bounds.scaled_distance(middle, 0), infinite);
}

TEST_F(SizeBoundsTest, BoundRisesFromACriticalPointAndEndsFourVoxelsAway) {
  CriticalPoint point;
  point.position = middle;
  point.distance = 0.1 * voxel;
  bounds.add(critical_bounds({point}, 0.5, 0.02 * voxel, voxel));
  EXPECT_DOUBLE_EQ(bounds.at(0).h, 0.1 * voxel);
  EXPECT_DOUBLE_EQ(bounds.bound(middle), 0.1 * voxel);
  EXPECT_NEAR(bounds.bound(middle + Vector3d(0.0, voxel, 0.0)), (0.1 + delta) * voxel, 1e-12);
  EXPECT_GT(bounds.bound(middle + Vector3d(3.9 * voxel, 0.0, 0.0)), (0.1 + delta * 3.9 + 0.5) * voxel);
  EXPECT_EQ(bounds.bound(middle - Vector3d(0.0, 0.0, 4.1 * voxel)), infinite);
  EXPECT_EQ(bounds.bound(Vector3d::Zero()), infinite);
}

TEST_F(SizeBoundsTest, AnEdgeIsNotBelowTheLeast) {
  CriticalPoint point;
  point.position = middle;
  point.distance = 0.001 * voxel;
  EXPECT_DOUBLE_EQ(critical_bounds({point}, 0.5, 0.02 * voxel, voxel).front().h, 0.02 * voxel);
}

TEST_F(SizeBoundsTest, SaysWhichBoundsReachAPointAndABox) {
  const Vector3d aside = middle + Vector3d(6.0, 0.0, 0.0);
  bounds.add({{middle, 0.7, 1.0, 1.0}, {aside, 0.5, 1.0, 1.0}});  // each reaches 5 mm
  EXPECT_EQ(bounds.bound(1, aside), 0.5);
  EXPECT_EQ(bounds.bound(0, aside), infinite);
  EXPECT_EQ(bounds.reaching(middle), std::vector<std::uint32_t>{0});
  EXPECT_EQ(bounds.reaching(aside), std::vector<std::uint32_t>{1});
  EXPECT_EQ(bounds.reaching(0.5 * (middle + aside)), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_TRUE(bounds.reaching(middle + Vector3d(0.0, 6.0, 0.0)).empty());
  const auto box = [](const Vector3d& x) { return Eigen::AlignedBox3d(x, x + Vector3d::Ones()); };
  EXPECT_EQ(bounds.reaching(box(middle + Vector3d(-5.9, 0.0, 0.0))), std::vector<std::uint32_t>{0});
  EXPECT_EQ(bounds.reaching(box(middle + Vector3d(0.5, 0.0, 0.0))), (std::vector<std::uint32_t>{0, 1}));
}

TEST_F(SizeBoundsTest, AroundAFlatPlaceTheBoundStaysAndThenRises) {
  const SizeBound bound{middle, 0.7, 1.2, 1.0};
  bounds.add({bound});
  for (const double away : {0.0, 0.6, 1.19}) EXPECT_DOUBLE_EQ(bounds.bound(middle + Vector3d(away, 0, 0)), 0.7);
  EXPECT_NEAR(bounds.bound(middle + Vector3d(2.2, 0.0, 0.0)), 0.7 + delta, 1e-12);
  EXPECT_NEAR(bounds.bound(middle + Vector3d(4.2, 0.0, 0.0)), 0.7 + 3.0 * delta + 0.125 * 4.0, 1e-12);
  EXPECT_EQ(bounds.bound(middle + Vector3d(5.3, 0.0, 0.0)), infinite);
}

// Bounds of very different reach are in different grids; still the smallest of all bounds holds.
TEST_F(SizeBoundsTest, TheSmallestBoundHolds) {
  std::vector<SizeBound> all;
  for (int n = 0; n < 60; ++n) {
    const Vector3d at = surface.extent().cwiseProduct(
        Vector3d(std::abs(std::sin(n)), std::abs(std::sin(2.3 * n + 1)), std::abs(std::sin(3.7 * n + 2))));
    const double unit = voxel * std::exp2(n % 9 - 6);
    all.push_back({at, 0.7 * unit, n % 2 == 0 ? 0.0 : unit, unit});
  }
  bounds.add({all.begin(), all.begin() + 20});
  bounds.add({all.begin() + 20, all.end()});
  ASSERT_EQ(bounds.size(), all.size());
  for (int n = 0; n < 500; ++n) {
    const Vector3d x = surface.extent().cwiseProduct(
        Vector3d(std::abs(std::sin(1.1 * n)), std::abs(std::sin(2.7 * n)), std::abs(std::sin(3.1 * n + 1))));
    double bound = infinite;
    double units = infinite;
    for (std::size_t i = 0; i < all.size(); ++i) {
      SizeBounds alone(surface, delta);
      alone.add({all[i]});
      bound = std::min(bound, alone.bound(x));
      if (i >= 20 && alone.bound(x) < infinite) units = std::min(units, (x - all[i].position).norm() / all[i].scale);
    }
    EXPECT_EQ(bounds.bound(x), bound);
    EXPECT_EQ(bounds.scaled_distance(x, 20), units);
  }
}

}  // namespace
}  // namespace isobench::particles
