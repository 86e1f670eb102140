#include "isobench/methods/sizing/coarse_request.h"

#include <gtest/gtest.h>

namespace isobench {
namespace {

TEST(CoarseRequest, IsNoticedWhereAnEdgeIsLongerThanTheObject) {
  const TriangleMesh tetrahedron{{{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {0.0, 4.0, 0.0}, {0.0, 0.0, 5.0}}, {}, {}, {}};
  SizingRequest request;
  request.edge_length = 4.9;
  EXPECT_EQ(coarse_request(request, tetrahedron), "");
  EXPECT_EQ(coarse_request(request, {}), "");
  request.edge_length = 20.0;
  EXPECT_EQ(coarse_request(request, tetrahedron),
            "the object is 5 mm long, less than one edge of 20 mm: the mesh has as few vertices as show its topology, "
            "4; ask for shorter edges");
}

TEST(CoarseRequest, IsNoticedWhereAMeshHasFarMoreVertices) {
  TriangleMesh twelve;
  twelve.vertices.resize(12, Eigen::Vector3d::Zero());
  SizingRequest request;
  EXPECT_EQ(coarse_request(request, twelve), "");
  request.vertices = 6.0;
  EXPECT_EQ(coarse_request(request, twelve), "");
  request.vertices = 3.0;
  EXPECT_EQ(coarse_request(request, twelve),
            "3 vertices were asked for, but the topology of the surface needs more: the mesh has 12");
}

}  // namespace
}  // namespace isobench
