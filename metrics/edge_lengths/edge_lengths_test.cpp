// Edge lengths over h0, against closed forms.
#include "isobench/metrics/edge_lengths/edge_lengths.h"

#include <gtest/gtest.h>

#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/metrics/measurement.h"
#include "isobench/metrics/test_surfaces.h"

namespace isobench {

namespace {

/// With the same h0 at every vertex.
EdgeLengthFigures edges_over(const TriangleMesh& mesh, double h0) {
  return measure_edge_lengths(mesh, mesh_edges(mesh), std::vector<double>(mesh.vertices.size(), h0));
}

Measurement measured(TriangleMesh mesh, const SizingField& sizing) {
  Monitor monitor;
  return measure(mesh, {.sizing = &sizing}, monitor);
}

TEST(EdgeLengths, UniformSizing) {
  // Legs of 3 and 4, hypotenuse of 5.
  const TriangleMesh mesh =
      sample_meshes::mesh({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {0, 0, 9}, {1, 0, 9}, {0, 1, 9}}, {{0, 1, 2}, {3, 4, 5}});
  const EdgeLengthFigures figures = edges_over(mesh, 4.0);
  EXPECT_NEAR(figures.over_h0_max, 1.25, 1e-15);
  EXPECT_NEAR(figures.over_h0_mean, (3.0 + 4.0 + 5.0 + 1.0 + 1.0 + std::sqrt(2.0)) / 24.0, 1e-15);
  EXPECT_EQ(figures.exceed_count, 1U) << "the edge of exactly 4 does not exceed 4";
  EXPECT_NEAR(figures.exceed_percent, 100.0 / 6.0, 1e-12);
  EXPECT_EQ(figures.exceed_triangle_percent, 50.0);
  EXPECT_EQ(figures.histogram.counts[125], 1U);
  EXPECT_EQ(measured(mesh, SizingField(4.0)).figure("floor_area_percent"), 0.0) << "a uniform field has no floor";
}

TEST(EdgeLengths, SharedEdgesCountOnce) {
  const EdgeLengthFigures figures = edges_over(sample_meshes::tetrahedron(), 1.2);
  EXPECT_EQ(figures.exceed_count, 3U);
  EXPECT_EQ(figures.exceed_percent, 50.0);
  EXPECT_EQ(figures.exceed_triangle_percent, 100.0);
}

TEST(EdgeLengths, VaryingSizingAndItsFloor) {
  // h0 grows along x: 2 + 0.1 x, but 2.5 below x = 5, its floor; the mesh lies on the plane z = 10.25.
  const Isosurface surface = plane();
  const auto band = std::make_shared<const Band>(surface, 2);
  std::vector<float> h0(band->size());
  for (std::size_t n = 0; n < h0.size(); ++n) {
    h0[n] = static_cast<float>(std::max(2.5, 2.0 + 0.1 * band->position(n).x()));
  }
  const SizingField sizing(band, h0, h0, 2.5);
  const TriangleMesh mesh = sample_meshes::mesh({{2, 4, 10.25}, {12, 4, 10.25}, {4, 8, 10.25}}, {{0, 1, 2}});
  const Measurement figures = measured(mesh, sizing);
  // h0 at the corners: 2.5, 3.2, 2.5. The longest edge is 10 mm over a mean of 2.85.
  EXPECT_NEAR(figures.number("edge_over_h0_max"), 10.0 / 2.85, 1e-6);
  EXPECT_NEAR(figures.number("edge_over_h0_mean"), (10.0 / 2.85 + std::sqrt(80.0) / 2.85 + std::sqrt(20.0) / 2.5) / 3.0,
              1e-6);
  EXPECT_NEAR(figures.number("floor_area_percent"), 200.0 / 3.0, 1e-9);
  EXPECT_EQ(figures.figure("edge_over_h0_exceed_count"), 3.0);
}

// A method whose own field was larger by a half than the one that was asked for.
TEST(EdgeLengths, AreMeasuredAgainstTheMethodsOwnH0Too) {
  TriangleMesh mesh = sample_meshes::torus(40);
  const SizingField sizing(0.25);
  const Measurement alone = measured(mesh, sizing);
  EXPECT_GT(alone.number("edge_over_h0_exceed_percent"), 0.0);
  EXPECT_EQ(alone.figure("edge_over_own_h0_max"), alone.figure("edge_over_h0_max"));
  EXPECT_EQ(alone.figure("edge_over_own_h0_exceed_percent"), alone.figure("edge_over_h0_exceed_percent"));
  EXPECT_EQ(alone.figure("edge_over_own_h0_exceed_triangle_percent"),
            alone.figure("edge_over_h0_exceed_triangle_percent"));
  mesh.vertex_data[own_h0].assign(mesh.vertices.size(), 0.375);
  const Measurement both = measured(mesh, sizing);
  EXPECT_EQ(both.figure("edge_over_h0_max"), alone.figure("edge_over_h0_max"));
  EXPECT_EQ(both.figure("edge_over_h0_exceed_percent"), alone.figure("edge_over_h0_exceed_percent"));
  EXPECT_NEAR(both.number("edge_over_own_h0_max"), alone.number("edge_over_h0_max") / 1.5, 1e-12);
  EXPECT_EQ(both.figure("edge_over_own_h0_exceed_percent"), 0.0);
  EXPECT_EQ(both.figure("edge_over_own_h0_exceed_triangle_percent"), 0.0);
}

TEST(EdgeLengths, WithoutEdgesNothingIsMeasured) {
  const Measurement figures = measured(sample_meshes::mesh({{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}}), SizingField(1.0));
  EXPECT_EQ(figures.figure("edge_over_h0_exceed_count"), std::nullopt);
  EXPECT_EQ(figures.figure("edge_over_h0_max"), std::nullopt);
  EXPECT_EQ(figures.figure("valence_6_percent"), std::nullopt);
  EXPECT_EQ(figures.figure("unused_vertices"), 2.0);
}

}  // namespace

}  // namespace isobench
