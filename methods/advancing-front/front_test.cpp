#include "isobench/methods/advancing-front/front.h"

#include <gtest/gtest.h>

#include "isobench/methods/mesh/mesh_facts.h"

namespace isobench::advancing_front {
namespace {

Vertex upright(double x, double y, double z = 0.0) { return {{x, y, z}, {0.0, 0.0, 1.0}, 1.0}; }

MeshFacts facts_of(const Front& front) {
  TriangleMesh mesh;
  for (const Vertex& v : front.vertices()) mesh.vertices.push_back(v.x);
  mesh.triangles = front.triangles();
  return mesh_facts(mesh);
}

/// The vertices of a loop, beginning at a node.
std::vector<std::uint32_t> loop_of(const Front& front, int node) {
  std::vector<std::uint32_t> vertices;
  int n = node;
  do {
    vertices.push_back(front.node(n).vertex);
    EXPECT_EQ(front.previous(front.next(n)), n);
    n = front.next(n);
  } while (n != node);
  return vertices;
}

using Loop = std::vector<std::uint32_t>;

TEST(Front, ASeedIsRoundedTheOtherWay) {
  Front front(0.1);
  const int first = front.seed({upright(0, 0), upright(1, 0), upright(0, 1)});
  EXPECT_EQ(loop_of(front, first), (Loop{0, 2, 1}));
  EXPECT_EQ(front.alive(), 3U);
}

TEST(Front, GrowsAndConnectsToAClosedTetrahedron) {
  Front front(0.1);
  const int first = front.seed({upright(0, 0), upright(0, 1), upright(1, 0)});  // seen from below
  const int made = front.grow(first, upright(0.3, 0.3, 1.0));
  EXPECT_EQ(loop_of(front, first), (Loop{0, 3, 2, 1}));
  std::vector<int> changed;
  EXPECT_EQ(front.connect(front.next(made), made, changed), Link::ear);
  ASSERT_EQ(changed.size(), 1U);
  EXPECT_EQ(front.alive(), 3U);
  EXPECT_EQ(front.connect(changed[0], front.previous(changed[0]), changed), Link::closed);
  EXPECT_EQ(front.alive(), 0U);
  const MeshFacts facts = facts_of(front);
  EXPECT_EQ(facts.open_edges, 0U);
  EXPECT_EQ(facts.euler, 2);
  EXPECT_NEAR(facts.volume, 1.0 / 6.0, 1e-12);
}

TEST(Front, ConnectingAcrossALoopSplitsIt) {
  Front front(0.1);
  const int first =
      front.boundary({upright(0, 0), upright(1, 0), upright(2, 0), upright(2, 1), upright(1, 1), upright(0, 1)});
  const int opposite = front.previous(front.previous(first));  // (1, 1)
  std::vector<int> changed;
  EXPECT_EQ(front.connect(first, opposite, changed), Link::split);
  ASSERT_EQ(changed.size(), 2U);
  EXPECT_EQ(loop_of(front, changed[0]), (Loop{0, 4, 5}));
  EXPECT_EQ(loop_of(front, changed[1]), (Loop{4, 1, 2, 3}));
  EXPECT_EQ(front.alive(), 7U);  // vertex 4 has a node in either loop
}

TEST(Front, ConnectingTwoLoopsMergesThem) {
  Front front(0.1);
  const int outer = front.boundary({upright(0, 0), upright(9, 0), upright(9, 9), upright(0, 9)});
  const int inner = front.boundary(
      {upright(3, 3), upright(3, 6), upright(6, 6), upright(6, 3)});  // the region to mesh lies outside it
  std::vector<int> changed;
  EXPECT_EQ(front.connect(outer, inner, changed), Link::merge);
  EXPECT_EQ(loop_of(front, outer), (Loop{0, 4, 5, 6, 7, 4, 1, 2, 3}));
}

TEST(Front, RefusesEdgesThatHaveTheirTwoTrianglesOrTwoGaps) {
  Front front(0.1);
  const int first = front.seed({upright(0, 0), upright(0, 1), upright(1, 0)});
  const int made = front.grow(first, upright(0.3, 0.3, 1.0));
  // The loop is 0 → 3 → 2 → 1. The edge 0–2 has two triangles already, so the corner at 3 must not be cut off again.
  EXPECT_FALSE(front.connectable(first, front.next(made)));
  EXPECT_TRUE(front.connectable(front.next(made), made));
  EXPECT_FALSE(front.connectable(first, first));
}

TEST(Front, AnAbandonedLoopIsOffTheFront) {
  Front front(0.1);
  const int first = front.boundary({upright(0, 0), upright(1, 0), upright(1, 1), upright(0, 1)});
  EXPECT_EQ(front.abandon(first), 4U);
  EXPECT_EQ(front.alive(), 0U);
  std::vector<int> found;
  front.edges().near({0.5, 0.5, 0.0}, 2.0, 0.0, found);
  EXPECT_TRUE(found.empty());
}

TEST(Front, OnlyVerticesLeftBehindCountAsMeshed) {
  Front front(0.1);
  const int first = front.seed({upright(0, 0), upright(0, 1), upright(1, 0)});
  EXPECT_FALSE(front.is_behind(upright(0.1, 0.0), 0.5, 0.1));  // the vertex is still on the front
  const int made = front.grow(first, upright(0.3, 0.3, 1.0));
  std::vector<int> changed;
  front.connect(front.next(made), made, changed);
  front.connect(changed[0], front.previous(changed[0]), changed);
  EXPECT_TRUE(front.is_behind(upright(0.1, 0.0), 0.5, 0.1));
  Vertex turned = upright(0.1, 0.0);
  turned.normal = -turned.normal;
  EXPECT_FALSE(front.is_behind(turned, 0.5, 0.1));  // another sheet
}

TEST(Front, WhatWasMadeLastCanBeTakenBack) {
  Front front(0.1);
  const int kept = front.seed({upright(0, 0), upright(0, 1), upright(1, 0)});
  const std::size_t triangles = front.triangles().size(), vertices = front.vertices().size();
  const int second = front.seed({upright(5, 0), upright(5, 1), upright(6, 0)});
  front.grow(second, upright(5.3, 0.3, 1.0));
  EXPECT_TRUE(front.is_open_from(vertices));
  front.take_back(triangles, vertices);
  EXPECT_FALSE(front.is_open_from(vertices));
  EXPECT_EQ(front.triangles().size(), triangles);
  EXPECT_EQ(loop_of(front, kept), (Loop{0, 2, 1}));
  EXPECT_EQ(front.alive(), 3U);
  // The vertices stay, so that no front starts here again.
  EXPECT_TRUE(front.covers(upright(5.1, 0.1), 0.5, 0.1));
  EXPECT_FALSE(front.covers(upright(9.0, 0.1), 0.5, 0.1));
}

}  // namespace
}  // namespace isobench::advancing_front
