#include "isobench/metrics/topology/topology.h"

#include <gtest/gtest.h>

#include <numeric>

#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/metrics/valence/valence.h"

namespace isobench {

namespace {

std::vector<int> valence_of_each(const TriangleMesh& mesh) { return valences(mesh, mesh_edges(mesh)); }
ValenceFigures valences_of(const TriangleMesh& mesh) { return summarize_valences(valence_of_each(mesh)); }

using sample_meshes::box;
using sample_meshes::tetrahedron;
using sample_meshes::together;

TEST(Topology, Tetrahedron) {
  const TopologyFigures figures = measure_topology(tetrahedron());
  EXPECT_EQ(figures.components, 1U);
  EXPECT_EQ(figures.euler, 2);
  EXPECT_TRUE(figures.closed_manifold());
  EXPECT_EQ(figures.self_intersections, 0U);
}

TEST(Topology, TorusAndSeparateParts) {
  const TopologyFigures torus = measure_topology(sample_meshes::torus(20));
  EXPECT_EQ(torus.euler, 0);
  EXPECT_TRUE(torus.closed_manifold());
  const TopologyFigures parts = measure_topology(together(sample_meshes::torus(20), box({9, 9, 9}, {10, 10, 10})));
  EXPECT_EQ(parts.components, 2U);
  EXPECT_EQ(parts.euler, 2);
}

TEST(Topology, UnusedVerticesDoNotCount) {
  TriangleMesh mesh = tetrahedron();
  mesh.vertices.insert(mesh.vertices.begin(), 3, Eigen::Vector3d::Ones());
  for (Triangle& triangle : mesh.triangles) {
    for (std::uint32_t& v : triangle) v += 3;
  }
  EXPECT_EQ(measure_topology(mesh).euler, 2);
  EXPECT_EQ(valences_of(mesh).unused_vertices, 3U);
}

TEST(Topology, TwoTetrahedraSharingAVertex) {
  TriangleMesh mesh = tetrahedron();
  mesh.vertices.insert(mesh.vertices.end(), {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}});
  mesh.triangles.insert(mesh.triangles.end(), {{0, 4, 5}, {0, 6, 4}, {4, 6, 5}, {5, 6, 0}});
  const TopologyFigures figures = measure_topology(mesh);
  EXPECT_EQ(figures.components, 2U);
  EXPECT_EQ(figures.euler, 3);
  EXPECT_EQ(figures.nonmanifold_vertices, 1U);
  EXPECT_EQ(figures.nonmanifold_edges, 0U);
  EXPECT_EQ(figures.misoriented_edges, 0U);
  EXPECT_EQ(figures.boundary_edges, 0U);
  EXPECT_FALSE(figures.closed_manifold());
  EXPECT_EQ(figures.self_intersections, 0U);
}

TEST(Topology, TwoTetrahedraSharingAnEdge) {
  TriangleMesh mesh = tetrahedron();
  mesh.vertices.insert(mesh.vertices.end(), {{0, -1, 0}, {0, 0, -1}});
  mesh.triangles.insert(mesh.triangles.end(), {{0, 4, 1}, {0, 1, 5}, {1, 4, 5}, {4, 0, 5}});
  const TopologyFigures figures = measure_topology(mesh);
  EXPECT_EQ(figures.components, 1U) << "connected over the common edge";
  EXPECT_EQ(figures.euler, 6 - 11 + 8);
  EXPECT_EQ(figures.nonmanifold_edges, 1U);
  EXPECT_EQ(figures.nonmanifold_vertices, 2U) << "the edge's ends";
  EXPECT_EQ(figures.boundary_edges, 0U);
}

TEST(Topology, ThreeTrianglesOnOneEdge) {
  const TopologyFigures figures = measure_topology(sample_meshes::mesh(
      {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}));
  EXPECT_EQ(figures.nonmanifold_edges, 1U);
  EXPECT_EQ(figures.boundary_edges, 6U);
  EXPECT_EQ(figures.nonmanifold_vertices, 2U);
  EXPECT_EQ(figures.components, 1U);
  EXPECT_EQ(figures.euler, 5 - 7 + 3);
}

TEST(Topology, MoebiusStrip) {
  const TopologyFigures figures = measure_topology(sample_meshes::moebius_strip(20));
  EXPECT_EQ(figures.euler, 0);
  EXPECT_EQ(figures.boundary_edges, 40U);
  EXPECT_EQ(figures.misoriented_edges, 1U) << "where the twist is";
  EXPECT_EQ(figures.nonmanifold_vertices, 0U);
}

TEST(Topology, OpenBoxAndTurnedTriangle) {
  TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
  TriangleMesh turned = mesh;
  std::swap(turned.triangles[5][0], turned.triangles[5][1]);
  EXPECT_EQ(measure_topology(turned).misoriented_edges, 3U);
  mesh.triangles.pop_back();
  mesh.triangles.pop_back();
  const TopologyFigures figures = measure_topology(mesh);
  EXPECT_EQ(figures.boundary_edges, 4U);
  EXPECT_EQ(figures.euler, 1);
  EXPECT_EQ(figures.nonmanifold_vertices, 0U) << "an open fan is one fan";
}

TEST(Topology, SameTriangleTwiceAndCollapsedTriangles) {
  TriangleMesh mesh = tetrahedron();
  mesh.triangles.push_back(mesh.triangles.front());
  const TopologyFigures twice = measure_topology(mesh);
  EXPECT_EQ(twice.nonmanifold_edges, 3U);
  EXPECT_EQ(twice.self_intersections, 1U);
  mesh.triangles.back() = {0, 0, 1};
  EXPECT_TRUE(measure_topology(mesh).closed_manifold());
  EXPECT_EQ(measure_topology(mesh).euler, 2);
}

TEST(Topology, BoxesThatPenetrateEachOther) {
  const TopologyFigures figures = measure_topology(together(box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})));
  EXPECT_EQ(figures.components, 2U);
  EXPECT_EQ(figures.euler, 4);
  EXPECT_TRUE(figures.closed_manifold());
  EXPECT_GE(figures.self_intersections, 6U) << "a closed curve of six crossings";
}

TEST(Valence, CountsEdgesAtVertices) {
  const ValenceFigures torus = valences_of(sample_meshes::torus(10));
  EXPECT_EQ(torus.v6_percent, 100.0);
  EXPECT_EQ(torus.extreme_count, 0U);
  const TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
  const std::vector<int> valence = valence_of_each(mesh);
  EXPECT_EQ(std::accumulate(valence.begin(), valence.end(), 0), 2 * 18) << "a box of triangles has 18 edges";
  // Three edges of the box at each corner, and the diagonals of its six sides: three at corners 0 and 7, one elsewhere.
  EXPECT_EQ(valences_of(mesh).counts, (std::vector<std::size_t>{0, 0, 0, 0, 6, 0, 2}));
}

TEST(Valence, Percentages) {
  const ValenceFigures figures = summarize_valences({0, 3, 4, 5, 5, 6, 6, 6, 7, 8, 12});
  EXPECT_EQ(figures.unused_vertices, 1U);
  EXPECT_EQ(figures.lt5_percent, 20.0);
  EXPECT_EQ(figures.v5_percent, 20.0);
  EXPECT_EQ(figures.v6_percent, 30.0);
  EXPECT_EQ(figures.v7_percent, 10.0);
  EXPECT_EQ(figures.gt7_percent, 20.0);
  EXPECT_EQ(figures.extreme_count, 4U);
  EXPECT_EQ(figures.counts.size(), 13U);
}

TEST(Valence, AnOpenFan) {
  // The edges at a vertex are counted, not its triangles.
  const std::vector<int> valence =
      valence_of_each(sample_meshes::mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, {{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(valence, (std::vector<int>{3, 2, 3, 2}));
}

}  // namespace

}  // namespace isobench
