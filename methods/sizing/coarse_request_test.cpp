#include "isobench/methods/sizing/coarse_request.h"

#include <gtest/gtest.h>

namespace isobench {
namespace {

TEST(CoarseRequest, IsNoticed) {
  const TriangleMesh tetrahedron{{{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {0.0, 4.0, 0.0}, {0.0, 0.0, 5.0}}, {}, {}, {}};
  const auto by_edge = [&](double length) { return coarse_request({.edge_length = length}, tetrahedron); };
  EXPECT_EQ(by_edge(4.9), "");
  EXPECT_EQ(by_edge(20.0),
            "the object is 5 mm long, less than one edge of 20 mm: the mesh has as few vertices as show its topology, "
            "4; ask for shorter edges");
  TriangleMesh many = tetrahedron;
  many.vertices.resize(12, Eigen::Vector3d::Zero());
  const auto by_count = [&](double count) { return coarse_request({.vertices = count}, many); };
  EXPECT_EQ(by_count(6.0), "");
  EXPECT_EQ(by_count(3.0), "3 vertices were asked for, but the topology of the surface needs more: the mesh has 12");
  EXPECT_EQ(coarse_request({.epsilon = 0.5, .delta = 0.3}, tetrahedron), "");
  EXPECT_EQ(coarse_request({.edge_length = 1.0}, {}), "");
}

}  // namespace
}  // namespace isobench
