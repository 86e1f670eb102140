#include "isobench/methods/sizing/medial_axis/axis_difference.h"

#include <gtest/gtest.h>

namespace isobench {
namespace {

Curvatures flat() {
  Curvatures k;
  k.k1 = 0.01;
  return k;
}

SurfaceSamples samples_at(const std::vector<Eigen::Vector3d>& points) {
  SurfaceSamples samples;
  samples.points = points;
  samples.curvature.assign(points.size(), flat());
  return samples;
}

// Three samples far from each other, with balls of radius 1, 5 and 5 below them. The second ball has no foot point near
// it.
TEST(AxisDifference, TellsThinPartsFromWhereTheAxisWasNotFound) {
  const SurfaceSamples samples = samples_at({{0, 0, 0}, {100, 0, 0}, {200, 0, 0}});
  const MedialBalls balls{{{0, 0, -1}, {100, 0, -5}, {200, 0, -5}}, {1, 5, 5}};
  const MedialBalls feet{{{1.5, 0, -2}, {100, 0, -9}, {200, 0, -5.5}}, {2, 9, 5.5}};
  const AxisDifference found = axis_difference(samples, feet, balls, 1.0, 50.0);
  EXPECT_EQ(found.place, (std::vector<AxisPlace>{AxisPlace::thin, AxisPlace::missed, AxisPlace::other}));
  EXPECT_NEAR(found.by_feet[0], 2.5, 1e-12);
  EXPECT_NEAR(found.by_feet[1], 9.0, 1e-12);
  EXPECT_NEAR(found.by_balls[1], 5.0, 1e-12);
  EXPECT_NEAR(found.median, 0.8, 1e-12);
  EXPECT_NEAR(found.differing, 200.0 / 3.0, 1e-12);
  EXPECT_NEAR(found.share_of_differing[0], 50.0, 1e-12);
  EXPECT_NEAR(found.share_of_differing[1], 50.0, 1e-12);
  EXPECT_EQ(found.share_of_differing[2], 0.0);
}

// Where the radius of curvature is smaller than both distances, the two sizes are equal.
TEST(AxisDifference, IsOfTheSmallerBound) {
  SurfaceSamples samples = samples_at({{0, 0, 0}});
  samples.curvature[0].k1 = -0.25;
  const AxisDifference found = axis_difference(samples, {{{0, 0, -9}}, {9}}, {{{0, 0, -5}}, {5}}, 1.0, 50.0);
  EXPECT_EQ(found.by_feet[0], 4.0);
  EXPECT_EQ(found.by_balls[0], 4.0);
  EXPECT_EQ(found.differing, 0.0);
}

TEST(AxisDifference, WithoutAnAxisIsOfTheCap) {
  const AxisDifference found = axis_difference(samples_at({{0, 0, 0}}), {}, {{{0, 0, -5}}, {5}}, 1.0, 20.0);
  EXPECT_EQ(found.by_feet[0], 20.0);
  EXPECT_EQ(found.by_balls[0], 5.0);
  EXPECT_EQ(found.place[0], AxisPlace::missed);
}

}  // namespace
}  // namespace isobench
