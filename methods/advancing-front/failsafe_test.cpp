#include "isobench/methods/advancing-front/failsafe.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace isobench::advancing_front {
namespace {

/// The plane z = 3.5 with the object below it.
Isosurface plane() {
  FloatVolume v;
  v.lattice.size = {12, 12, 8};
  v.samples.resize(v.lattice.nodes());
  for (int k = 0; k < 8; ++k) {
    for (int j = 0; j < 12; ++j) {
      for (int i = 0; i < 12; ++i) v.at(i, j, k) = 3.5F - static_cast<float>(k);
    }
  }
  return Isosurface(std::move(v), 0.0);
}

Vertex on_rim(double x, double y) { return {{x, y, 3.5}, {0.0, 0.0, 1.0}, 1.0}; }

/// The signed area of the triangles, positive if they are counter-clockwise seen from outside.
double area(const Front& front) {
  double sum = 0.0;
  for (const auto& [a, b, c] : front.triangles()) {
    const Eigen::Vector3d& x = front.vertices()[a].x;
    sum += 0.5 * (front.vertices()[b].x - x).cross(front.vertices()[c].x - x)[2];
  }
  return sum;
}

TEST(AdvancingFrontFailsafe, CutsTheSharpestCornerFirst) {
  Front front(0.1);
  // A kite: the corner at (6, 2) is the sharpest and is cut off. A cut through it would leave two slivers.
  front.boundary({on_rim(6, 2), on_rim(7, 7), on_rim(6, 8), on_rim(5, 7)});
  const auto holes = close_holes(plane(), front);
  ASSERT_EQ(holes.size(), 1U);
  EXPECT_EQ(holes[0].edges, 4U);
  EXPECT_EQ(holes[0].triangles, 2U);
  EXPECT_TRUE(holes[0].closed);
  EXPECT_LT((holes[0].centre - Eigen::Vector3d(6, 6, 3.5)).norm(), 1e-12);
  EXPECT_EQ(front.alive(), 0U);
  ASSERT_EQ(front.triangles().size(), 2U);
  Triangle first = front.triangles()[0];
  std::sort(first.begin(), first.end());
  EXPECT_EQ(first, (Triangle{0, 1, 3}));
  EXPECT_NEAR(area(front), 6.0, 1e-12);
}

// Cutting by angle alone, as published, may fold a triangle over at a reflex corner. The hole is still filled: the
// signed areas add up to that of the hole.
TEST(AdvancingFrontFailsafe, FillsAHoleWithAReflexCorner) {
  Front front(0.1);
  front.boundary({on_rim(2, 2), on_rim(8, 2), on_rim(8, 4), on_rim(4, 4), on_rim(4, 8), on_rim(2, 8)});
  const auto holes = close_holes(plane(), front);
  ASSERT_EQ(holes.size(), 1U);
  EXPECT_EQ(holes[0].edges, 6U);
  EXPECT_EQ(holes[0].triangles, 4U);
  EXPECT_NEAR(area(front), 20.0, 1e-12);
  EXPECT_EQ(front.alive(), 0U);
}

TEST(AdvancingFrontFailsafe, ClosesEveryLoop) {
  Front front(0.1);
  front.boundary({on_rim(1, 1), on_rim(2, 1), on_rim(1, 2)});
  front.boundary({on_rim(5, 5), on_rim(7, 5), on_rim(7, 7), on_rim(5, 7)});
  const auto holes = close_holes(plane(), front);
  ASSERT_EQ(holes.size(), 2U);
  EXPECT_EQ(holes[0].triangles + holes[1].triangles, 3U);
  EXPECT_EQ(front.alive(), 0U);
  EXPECT_TRUE(close_holes(plane(), front).empty());
}

}  // namespace
}  // namespace isobench::advancing_front
