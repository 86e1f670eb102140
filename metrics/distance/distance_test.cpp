// Distance to the surface and edge lengths over h0, against closed forms.
#include "isobench/metrics/distance/distance.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/metrics/distance/test_surfaces.h"
#include "isobench/metrics/shape/edge_lengths.h"

namespace isobench {

namespace {

TriangleMesh at_heights(double a, double b, double c) {
  return sample_meshes::mesh({{5, 5, 10.25 + a}, {15, 5, 10.25 + b}, {5, 15, 10.25 + c}}, {{0, 1, 2}});
}

TEST(Distance, ConstantOffsetFromAPlane) {
  const DistanceFigures figures = measure_distance(at_heights(0.2, 0.2, 0.2), plane());
  EXPECT_NEAR(figures.mean, 0.2, 1e-6);
  EXPECT_NEAR(figures.max, 0.2, 1e-6);
  EXPECT_NEAR(figures.vertex_max, 0.2, 1e-6);
  EXPECT_NEAR(figures.mean_voxels, 0.2, 1e-6) << "a voxel is ∛(1 · 2 · 0.5) = 1 mm";
  EXPECT_EQ(figures.unprojected, 0U);
}

TEST(Distance, LinearDistanceIsIntegratedExactly) {
  std::vector<double> at_vertices;
  const DistanceFigures figures = measure_distance(at_heights(0.1, 0.4, 0.7), plane(), &at_vertices);
  EXPECT_NEAR(figures.mean, 0.4, 1e-6);
  EXPECT_NEAR(figures.max, 0.7, 1e-6);
  ASSERT_EQ(at_vertices.size(), 3U);
  EXPECT_NEAR(at_vertices[0], 0.1, 1e-6);
  EXPECT_NEAR(at_vertices[1], 0.4, 1e-6);
}

TEST(Distance, IsWeightedByArea) {
  // A triangle at distance 0.3 and one of a quarter of its area on the surface.
  const TriangleMesh large = at_heights(0.3, 0.3, 0.3);
  const TriangleMesh small = sample_meshes::mesh({{5, 5, 10.25}, {10, 5, 10.25}, {5, 10, 10.25}}, {{0, 1, 2}});
  EXPECT_NEAR(measure_distance(sample_meshes::together(large, small), plane()).mean, 0.3 * 0.8, 1e-6);
}

/// A sphere of the given radius around the ball's centre, 2n² quads.
TriangleMesh sphere(double radius, std::uint32_t n) {
  TriangleMesh mesh = sample_meshes::torus(n);
  // The torus is taken only for its grid of longitudes and latitudes; the poles' triangles are left out.
  mesh.triangles.clear();
  for (std::uint32_t i = 0; i < 2 * n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const double u = M_PI * i / n;
      const double v = M_PI * (j + 0.5) / n;
      mesh.vertices[i * n + j] =
          Eigen::Vector3d(20, 20, 20) +
          radius * Eigen::Vector3d(std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), std::cos(v));
      const std::uint32_t next = (i + 1) % (2 * n);
      if (j + 1 == n) continue;
      mesh.triangles.push_back({i * n + j, i * n + j + 1, next * n + j + 1});
      mesh.triangles.push_back({i * n + j, next * n + j + 1, next * n + j});
    }
  }
  return mesh;
}

TEST(Distance, SphereHalfAMillimetreOutside) {
  // The spline moves the sphere inwards by κ·voxel²/3 = 0.03 mm (σ² = 1/3 voxel² smooths by σ²κ); chords sag by < 0.01
  // mm.
  const DistanceFigures figures = measure_distance(sphere(12.5, 60), ball());
  EXPECT_NEAR(figures.mean, 0.53, 0.01);
  EXPECT_NEAR(figures.vertex_max, 0.53, 0.01);
  EXPECT_EQ(figures.unprojected, 0U);
}

TEST(Distance, FarPointsAreCountedAndFinite) {
  // At the ball's centre the gradient vanishes: no projection from there.
  const TriangleMesh mesh = sample_meshes::mesh({{20, 20, 20}, {20, 20, 20}, {20, 20, 20}}, {{0, 1, 2}});
  const DistanceFigures figures = measure_distance(mesh, ball());
  EXPECT_GT(figures.unprojected, 0U);
  EXPECT_TRUE(std::isfinite(figures.max));
  EXPECT_GT(figures.max, 1.0);
}

TEST(Distance, SameBitsForAnyNumberOfThreads) {
  const TriangleMesh mesh = sphere(12.2, 40);
  const Isosurface surface = ball();
  const DistanceFigures figures = measure_distance(mesh, surface);
  for (const std::size_t threads : {1, 2, 4}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const DistanceFigures again = measure_distance(mesh, surface);
    EXPECT_EQ(again.mean, figures.mean);
    EXPECT_EQ(again.max, figures.max);
  }
}

TEST(EdgeLengths, UniformSizing) {
  // Legs of 3 and 4, hypotenuse of 5.
  const TriangleMesh mesh =
      sample_meshes::mesh({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {0, 0, 9}, {1, 0, 9}, {0, 1, 9}}, {{0, 1, 2}, {3, 4, 5}});
  std::vector<double> h0;
  const EdgeLengthFigures figures = measure_edge_lengths(mesh, SizingField(4.0), &h0);
  EXPECT_NEAR(figures.over_h0_max, 1.25, 1e-15);
  EXPECT_NEAR(figures.over_h0_mean, (3.0 + 4.0 + 5.0 + 1.0 + 1.0 + std::sqrt(2.0)) / 24.0, 1e-15);
  EXPECT_EQ(figures.exceed_count, 1U) << "the edge of exactly 4 does not exceed 4";
  EXPECT_NEAR(figures.exceed_percent, 100.0 / 6.0, 1e-12);
  EXPECT_EQ(figures.exceed_triangle_percent, 50.0);
  EXPECT_EQ(figures.floor_area_percent, 0.0);
  EXPECT_EQ(figures.histogram.counts[125], 1U);
  EXPECT_EQ(h0, std::vector<double>(6, 4.0));
}

TEST(EdgeLengths, SharedEdgesCountOnce) {
  const EdgeLengthFigures figures = measure_edge_lengths(sample_meshes::tetrahedron(), SizingField(1.2));
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
  const EdgeLengthFigures figures = measure_edge_lengths(mesh, sizing);
  // h0 at the corners: 2.5, 3.2, 2.5. The longest edge is 10 mm over a mean of 2.85.
  EXPECT_NEAR(figures.over_h0_max, 10.0 / 2.85, 1e-6);
  EXPECT_NEAR(figures.over_h0_mean, (10.0 / 2.85 + std::sqrt(80.0) / 2.85 + std::sqrt(20.0) / 2.5) / 3.0, 1e-6);
  EXPECT_NEAR(figures.floor_area_percent, 200.0 / 3.0, 1e-9);
  EXPECT_EQ(figures.exceed_count, 3U);
}

}  // namespace

}  // namespace isobench
