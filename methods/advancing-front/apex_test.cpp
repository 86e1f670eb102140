#include "isobench/methods/advancing-front/apex.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "isobench/datasets/phantoms/phantoms.h"

namespace isobench::advancing_front {
namespace {

const Isosurface& sphere() {
  static const Isosurface surface(sample_phantom(phantom("sphere"), 48), 0.0);
  return surface;
}

Eigen::Vector3d foot(const Eigen::Vector3d& direction) {
  // From inside outwards; the object is a ball at the centre of the volume.
  const Eigen::Vector3d centre = 0.5 * sphere().extent();
  Eigen::Vector3d x = centre;
  while (sphere().value(x) > 0.0) x += 0.2 * sphere().voxel() * direction.normalized();
  return sphere().project(x).value();
}

TEST(AdvancingFrontApex, KeepsBothDistancesAndLiesOnTheSurfaceToTheLeft) {
  const Eigen::Vector3d a = foot({1.0, 0.2, 0.1});
  const Eigen::Vector3d b = foot({1.0, 0.4, 0.1});
  const Eigen::Vector3d normal = outward_normal(sphere().value_gradient(a).gradient);
  for (const Sides sides : {Sides{3.0, 3.0}, Sides{4.0, 3.5}, Sides{8.0, 8.5}}) {
    const auto x = rotate_to_surface(sphere(), a, b, normal, sides);
    ASSERT_TRUE(x.has_value());
    EXPECT_NEAR((*x - a).norm(), sides.from_a, 1e-9);
    EXPECT_NEAR((*x - b).norm(), sides.from_b, 1e-9);
    const Jet jet = sphere().value_gradient(*x);
    EXPECT_LT(std::abs(jet.value) / jet.gradient.norm(), 1e-6 * sphere().voxel());
    EXPECT_GT((b - a).cross(*x - a).dot(normal), 0.0);
  }
}

TEST(AdvancingFrontApex, IsNoneWhereTheCircleMissesTheSurface) {
  const Eigen::Vector3d a = foot({1.0, 0.2, 0.1});
  const Eigen::Vector3d b = foot({1.0, 0.4, 0.1});
  const Eigen::Vector3d normal = outward_normal(sphere().value_gradient(a).gradient);
  const double far = 3.0 * sphere().extent().norm();
  EXPECT_FALSE(rotate_to_surface(sphere(), a, b, normal, {far, far}).has_value());
}

TEST(AdvancingFrontApex, SidesAreKeptWhereTheyMakeATriangleAndMadeToWhereNot) {
  const Sides good = feasible_sides(1.0, {1.1, 0.9});
  EXPECT_EQ(good.from_a, 1.1);
  EXPECT_EQ(good.from_b, 0.9);
  for (const Sides wanted : {Sides{0.3, 0.3}, Sides{3.0, 1.0}, Sides{0.2, 0.9}}) {
    const Sides made = feasible_sides(1.0, wanted);
    EXPECT_GE(made.from_a + made.from_b, 1.149);
    EXPECT_LT(std::abs(made.from_a - made.from_b), 1.0);
  }
}

TEST(AdvancingFrontApex, GrowsWithTheSidesThatTheSizingAsksFor) {
  const Step step = [](const Eigen::Vector3d&) { return 2.5; };
  const Vertex a = make_vertex(sphere(), step, foot({1.0, 0.2, 0.1}));
  const Vertex b = make_vertex(sphere(), step, foot({1.0, 0.3, 0.1}));
  EXPECT_NEAR(a.normal.dot((a.x - 0.5 * sphere().extent()).normalized()), 1.0, 1e-2);
  const GapAngles wide{3.1, 3.1};
  const auto apex = grown_apex(sphere(), step, a, b, 1.0, wide);
  ASSERT_TRUE(apex.has_value());
  EXPECT_NEAR((apex->x - a.x).norm(), 2.5, 1e-9);
  EXPECT_NEAR((apex->x - b.x).norm(), 2.5, 1e-9);
  const auto smaller = grown_apex(sphere(), step, a, b, 0.8, wide);
  ASSERT_TRUE(smaller.has_value());
  EXPECT_NEAR((smaller->x - a.x).norm(), 2.0, 1e-9);

  // The gap of 100° at a asks for 50°; b has room and asks for 60°. The position is the mean of both proposals.
  const auto turned = grown_apex(sphere(), step, a, b, 1.0, {100.0 / 180.0 * std::numbers::pi, 3.1});
  ASSERT_TRUE(turned.has_value());
  EXPECT_LT((turned->x - b.x).norm(), (apex->x - b.x).norm());
}

}  // namespace
}  // namespace isobench::advancing_front
