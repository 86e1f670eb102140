#include "isobench/methods/particles/mesh_edits/editable_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "isobench/methods/mesh/mesh_facts.h"
#include "isobench/methods/particles/mesh_edits/submesh.h"

namespace isobench::particles {
namespace {

using Index = EditableMesh::Index;

/// A torus of rows × columns quadrilaterals, each split into two triangles. Every valence is 6.
EditableMesh torus(Index rows, Index columns) {
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals;
  std::vector<Triangle> triangles;
  for (Index r = 0; r < rows; ++r) {
    for (Index c = 0; c < columns; ++c) {
      const double u = 2.0 * std::numbers::pi * r / rows;
      const double v = 2.0 * std::numbers::pi * c / columns;
      const Eigen::Vector3d out(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
      points.push_back(Eigen::Vector3d(3.0 * std::cos(u), 3.0 * std::sin(u), 0.0) + out);
      normals.push_back(out);
      const Index right = (r + 1) % rows * columns;
      const Index up = (c + 1) % columns;
      triangles.push_back({r * columns + c, right + c, right + up});
      triangles.push_back({r * columns + c, right + up, r * columns + up});
    }
  }
  return {points, normals, triangles};
}

/// Expects a closed mesh without pinches, with correct valences and this Euler characteristic.
void expect_valid(const EditableMesh& mesh, long euler = 0) {
  for (Index e = 0; e < mesh.half_edge_count(); ++e) {
    if (mesh.origin(e) == EditableMesh::none) continue;
    ASSERT_NE(mesh.twin(e), EditableMesh::none);
    EXPECT_EQ(mesh.twin(mesh.twin(e)), e);
    EXPECT_EQ(mesh.origin(mesh.twin(e)), mesh.target(e));
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!mesh.alive(v)) continue;
    Index fan = 0;
    Index e = mesh.out(v);
    do {
      EXPECT_EQ(mesh.origin(e), v);
      e = mesh.turn(e);
    } while (e != mesh.out(v) && ++fan < 100);
    EXPECT_EQ(fan + 1, mesh.valence(v));
  }
  const MeshFacts facts = mesh_facts(mesh.triangle_mesh());
  EXPECT_EQ(facts.euler, euler);
  EXPECT_EQ(facts.open_edges, 0U);
  EXPECT_EQ(facts.nonmanifold_edges, 0U);
}

TEST(EditableMesh, IsTheMeshThatItWasMadeFrom) {
  const EditableMesh mesh = torus(12, 8);
  expect_valid(mesh);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_TRUE(mesh.movable(v));
    EXPECT_EQ(mesh.valence(v), 6U);
  }
  EXPECT_EQ(mesh.triangle_mesh().triangles.size(), 192U);
}

TEST(EditableMesh, FlipsAnEdge) {
  EditableMesh mesh = torus(12, 8);
  const Index a = mesh.origin(0);
  const Index b = mesh.target(0);
  const Index c = mesh.apex(0);
  const Index d = mesh.apex(mesh.twin(0));
  ASSERT_TRUE(mesh.can_flip(0));
  mesh.flip(0);
  expect_valid(mesh);
  EXPECT_FALSE(mesh.adjacent(a, b));
  EXPECT_TRUE(mesh.adjacent(c, d));
  EXPECT_EQ(mesh.valence(a), 5U);
  EXPECT_EQ(mesh.valence(c), 7U);
}

TEST(EditableMesh, CollapsesAnEdge) {
  EditableMesh mesh = torus(12, 8);
  const Index a = mesh.origin(7);
  const Index b = mesh.target(7);
  ASSERT_TRUE(mesh.can_collapse(7));
  mesh.collapse(7);
  expect_valid(mesh);
  EXPECT_FALSE(mesh.alive(a));
  EXPECT_EQ(mesh.valence(b), 8U);
  EXPECT_EQ(mesh.triangle_mesh().triangles.size(), 190U);
}

TEST(EditableMesh, SplitsAnEdgeAndAVertex) {
  EditableMesh mesh = torus(12, 8);
  const Index m = mesh.split_edge(5, mesh.points[0], mesh.normals[0]);
  expect_valid(mesh);
  EXPECT_EQ(mesh.valence(m), 4U);
  const Index first = mesh.out(50);
  const Index last = mesh.turn(mesh.turn(mesh.turn(first)));
  const Index w = mesh.split_vertex(first, last, mesh.points[50], mesh.normals[50]);
  expect_valid(mesh);
  EXPECT_EQ(mesh.valence(w), 5U);
  EXPECT_EQ(mesh.valence(50), 5U);
  EXPECT_EQ(mesh.triangle_mesh().vertices.size(), 98U);
}

// On a tetrahedron, every flip would duplicate an edge, and every collapse would leave two triangles with the same
// corners.
TEST(EditableMesh, RefusesOperationsThatBreakTheMesh) {
  const std::vector<Eigen::Vector3d> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<Triangle> triangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  const EditableMesh mesh(points, points, triangles);
  expect_valid(mesh, 2);
  for (Index e = 0; e < mesh.half_edge_count(); ++e) {
    EXPECT_FALSE(mesh.can_flip(e));
    EXPECT_FALSE(mesh.can_collapse(e));
  }
}

// With three columns, the ends of an edge along a column share a neighbour that is in no triangle with both.
TEST(EditableMesh, KeepsTheLinkCondition) {
  EditableMesh mesh = torus(12, 3);
  std::size_t refused = 0;
  for (Index e = 0; e < mesh.half_edge_count(); ++e) refused += mesh.can_collapse(e) ? 0 : 1;
  EXPECT_GE(refused, 72U);
  EXPECT_LT(refused, mesh.half_edge_count());
}

TEST(EditableMesh, FixesABorder) {
  const std::vector<Eigen::Vector3d> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  const std::vector<Eigen::Vector3d> normals(5, Eigen::Vector3d::UnitZ());
  const EditableMesh mesh(points, normals, std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}});
  EXPECT_TRUE(mesh.movable(0));
  for (Index v = 1; v < 5; ++v) EXPECT_TRUE(mesh.fixed(v));
}

/// Two tetrahedra that meet in vertex 0.
EditableMesh pinch() {
  const std::vector<Eigen::Vector3d> points{{0, 0, 0},  {1, 0, 0},  {0, 1, 0}, {0, 0, 1},
                                            {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  const std::vector<Triangle> triangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2},
                                        {0, 4, 5}, {0, 6, 4}, {4, 6, 5}, {0, 5, 6}};
  return {points, points, triangles};
}

TEST(EditableMesh, FixesAPinch) {
  const EditableMesh mesh = pinch();
  EXPECT_TRUE(mesh.fixed(0));
  for (Index v = 1; v < 7; ++v) EXPECT_TRUE(mesh.movable(v));
}

// The submesh has one tetrahedron, in which vertex 0 has a single closed fan.
TEST(Submesh, KeepsFixedVerticesFixed) {
  EditableMesh mesh = pinch();
  mesh.fix(2);
  const std::vector<Index> centres{1};
  const Submesh submesh = extract_submesh(mesh, centres, 2);
  EXPECT_EQ(submesh.triangles.size(), 4U);
  ASSERT_EQ(submesh.vertices.size(), 4U);
  for (Index n = 0; n < 4; ++n)
    EXPECT_EQ(submesh.mesh.fixed(n), submesh.vertices[n] == 0 || submesh.vertices[n] == 2) << submesh.vertices[n];
}

}  // namespace
}  // namespace isobench::particles
