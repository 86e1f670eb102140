#include "isobench/methods/mesh/triangle_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "isobench/datasets/volume.h"

namespace isobench {
namespace {

// The tetrahedron of the origin and the unit points of the axes; triangles face outward, the volume is 1/6.
TriangleMesh unit_tetrahedron() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  mesh.vertex_data["height"] = {1, 2, 3, 4};
  return mesh;
}

// The volume by the divergence theorem; positive if triangles face outward.
double signed_volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles) {
    sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
  }
  return sum;
}

Lattice oblique(bool mirrored) {
  Lattice lattice;
  lattice.spacing = {1, 2, 3};
  lattice.origin = {-5, 7, 11};
  lattice.direction = Eigen::AngleAxisd(1.1, Eigen::Vector3d(3, -1, 2).normalized()).toRotationMatrix();
  if (mirrored) lattice.direction.col(2) *= -1.0;
  return lattice;
}

class MeshFrames : public testing::TestWithParam<bool> {};

TEST_P(MeshFrames, TheOutsideStaysOutside) {
  const Lattice lattice = oblique(GetParam());
  ASSERT_NEAR(signed_volume(unit_tetrahedron()), 1.0 / 6.0, 1e-15);
  // Coordinates in the lattice frame are in mm: the spacing must not scale the mesh.
  EXPECT_NEAR(signed_volume(to_world(unit_tetrahedron(), lattice)), 1.0 / 6.0, 1e-12);
  EXPECT_NEAR(signed_volume(to_local(unit_tetrahedron(), lattice)), 1.0 / 6.0, 1e-12);
}

TEST_P(MeshFrames, ToLocalUndoesToWorld) {
  const Lattice lattice = oblique(GetParam());
  const TriangleMesh before = unit_tetrahedron();
  const TriangleMesh world = to_world(before, lattice);
  EXPECT_TRUE(world.vertices[2].isApprox(lattice.origin + lattice.direction.col(1)));
  const TriangleMesh after = to_local(world, lattice);
  EXPECT_EQ(after.triangles, before.triangles);
  EXPECT_EQ(after.vertex_data, before.vertex_data);
  for (std::size_t v = 0; v < before.vertices.size(); ++v) {
    EXPECT_NEAR((after.vertices[v] - before.vertices[v]).norm(), 0.0, 1e-13);
  }
}

INSTANTIATE_TEST_SUITE_P(RightAndLeftHanded, MeshFrames, testing::Bool());

TEST(TriangleMesh, DropsVerticesThatNoTriangleUses) {
  TriangleMesh mesh;
  for (int n = 0; n < 5; ++n) mesh.vertices.emplace_back(n, 0, 0);
  mesh.triangles = {{1, 2, 4}};
  mesh.vertex_data["number"] = {0, 1, 2, 3, 4};
  EXPECT_EQ(drop_unused_vertices(mesh), 2U);
  ASSERT_EQ(mesh.vertices.size(), 3U);
  EXPECT_EQ(mesh.triangles[0], (Triangle{0, 1, 2}));
  EXPECT_EQ(mesh.vertices[2][0], 4.0);
  EXPECT_EQ(mesh.vertex_data["number"], (std::vector<double>{1, 2, 4}));
  EXPECT_EQ(drop_unused_vertices(mesh), 0U);
}

}  // namespace
}  // namespace isobench
