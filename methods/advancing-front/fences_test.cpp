#include "isobench/methods/advancing-front/fences.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace isobench::advancing_front {
namespace {

Vertex at(double x, double y, double z = 0.0, double up = 1.0) { return {{x, y, z}, {0.0, 0.0, up}, 1.0}; }

/// A wide loop round a region to mesh, with (0, 0) → (1, 0) as its first edge.
int wide_loop(Front& front) { return front.boundary({at(0, 0), at(1, 0), at(5, 0), at(5, 5), at(-5, 5), at(-5, 0)}); }

std::vector<int> all_edges(const Front& front) {
  std::vector<int> edges;
  for (int n = 0; n < front.node_count(); ++n) {
    if (front.node(n).alive) edges.push_back(n);
  }
  return edges;
}

Fence check(const Front& front, int base, const Vertex& apex, double margin) {
  return fences(front, {{&front.vertex(base), &front.vertex(front.next(base)), &apex}, base, -1}, all_edges(front),
                margin);
}

TEST(AdvancingFrontFences, RoomIsClear) {
  Front front(0.1);
  const int base = wide_loop(front);
  EXPECT_EQ(check(front, base, at(0.5, 0.87), 0.5), Fence::clear);
}

TEST(AdvancingFrontFences, AnEdgeAcrossAnotherIsCrossedAlsoWhereItPassesAbove) {
  for (const double height : {0.0, 0.3}) {
    Front front(0.1);
    const int base = wide_loop(front);
    front.boundary({at(-1, 0.5, height), at(2, 0.5, height), at(0.5, 2.0, height)});
    EXPECT_EQ(check(front, base, at(0.5, 0.87), 0.1), Fence::crossed) << height;
  }
}

TEST(AdvancingFrontFences, AnotherSheetIsNot) {
  Front opposite(0.1);
  int base = wide_loop(opposite);
  opposite.boundary({at(-1, 0.5, 0.1, -1.0), at(2, 0.5, 0.1, -1.0), at(0.5, 2.0, 0.1, -1.0)});
  EXPECT_EQ(check(opposite, base, at(0.5, 0.87), 0.1), Fence::clear);

  Front far_above(0.1);
  base = wide_loop(far_above);
  far_above.boundary({at(-1, 0.5, 3.0), at(2, 0.5, 3.0), at(0.5, 2.0, 3.0)});
  EXPECT_EQ(check(far_above, base, at(0.5, 0.87), 0.1), Fence::clear);
}

TEST(AdvancingFrontFences, ALoopInsideTheTriangleIsCrossed) {
  Front front(0.1);
  const int base = wide_loop(front);
  front.boundary({at(0.45, 0.3), at(0.5, 0.4), at(0.55, 0.3)});
  EXPECT_EQ(check(front, base, at(0.5, 0.87), 0.0), Fence::crossed);
}

TEST(AdvancingFrontFences, WhatComesWithinTheMarginIsNear) {
  Front front(0.1);
  const int base = wide_loop(front);
  front.boundary({at(-1, 1.2), at(2, 1.2), at(0.5, 3.0)});
  EXPECT_EQ(check(front, base, at(0.5, 0.87), 0.5), Fence::near);
  EXPECT_EQ(check(front, base, at(0.5, 0.87), 0.2), Fence::clear);
}

TEST(AdvancingFrontFences, GapsAreTheAnglesThatAreLeft) {
  Front front(0.1);
  const int base = wide_loop(front);
  const Vertex apex = at(0.5, 0.5 * std::numbers::sqrt3);
  const Tentative t{{&front.vertex(base), &front.vertex(front.next(base)), &apex}, base, -1};
  // The front is straight at both corners of the base: 180° minus the triangle's 60°.
  EXPECT_NEAR(gaps_left(front, t).value(), 2.0 * std::numbers::pi / 3.0, 1e-12);
  EXPECT_NEAR(smallest_angle(t), std::numbers::pi / 3.0, 1e-12);
  EXPECT_NEAR(circumradius_over_inradius(t), 2.0, 1e-12);
  EXPECT_NEAR(normal_agreement(t), 1.0, 1e-12);
  const Vertex below = at(0.5, -0.5);
  EXPECT_FALSE(
      gaps_left(front, {{&front.vertex(base), &front.vertex(front.next(base)), &below}, base, -1}).has_value());
}

TEST(AdvancingFrontFences, AnEarLeavesAGapOnlyAtItsNewEdge) {
  Front front(0.1);
  const int base = front.boundary({at(0, 0), at(1, 0), at(1, 1), at(0, 1)});
  const int apex = front.next(front.next(base));
  const Tentative ear{{&front.vertex(base), &front.vertex(front.next(base)), &front.vertex(apex)}, base, apex};
  EXPECT_NEAR(gaps_left(front, ear).value(), std::numbers::pi / 4.0, 1e-12);
}

}  // namespace
}  // namespace isobench::advancing_front
