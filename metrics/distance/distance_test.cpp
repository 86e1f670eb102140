// Distance to the surface, against closed forms.
#include "isobench/metrics/distance/distance.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/metrics/measurement.h"
#include "isobench/metrics/test_surfaces.h"

namespace isobench {

namespace {

DistanceFigures distances_of(const TriangleMesh& mesh, const Isosurface& surface,
                             std::vector<double>* at_vertices = nullptr) {
  return measure_distance(mesh, mesh_edges(mesh), surface, at_vertices);
}

TriangleMesh at_heights(double a, double b, double c) {
  return sample_meshes::mesh({{5, 5, 10.25 + a}, {15, 5, 10.25 + b}, {5, 15, 10.25 + c}}, {{0, 1, 2}});
}

TEST(Distance, ConstantOffsetFromAPlane) {
  const DistanceFigures figures = distances_of(at_heights(0.2, 0.2, 0.2), plane());
  EXPECT_NEAR(figures.mean, 0.2, 1e-6);
  EXPECT_NEAR(figures.max, 0.2, 1e-6);
  EXPECT_NEAR(figures.vertex_max, 0.2, 1e-6);
  EXPECT_NEAR(figures.mean_voxels, 0.2, 1e-6) << "a voxel is ∛(1 · 2 · 0.5) = 1 mm";
  EXPECT_EQ(figures.unprojected, 0U);
}

TEST(Distance, LinearDistanceIsIntegratedExactly) {
  std::vector<double> at_vertices;
  const DistanceFigures figures = distances_of(at_heights(0.1, 0.4, 0.7), plane(), &at_vertices);
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
  EXPECT_NEAR(distances_of(sample_meshes::together(large, small), plane()).mean, 0.3 * 0.8, 1e-6);
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
  const DistanceFigures figures = distances_of(sphere(12.5, 60), ball());
  EXPECT_NEAR(figures.mean, 0.53, 0.01);
  EXPECT_NEAR(figures.vertex_max, 0.53, 0.01);
  EXPECT_EQ(figures.unprojected, 0U);
}

TEST(Distance, FarPointsAreCountedAndFinite) {
  // At the ball's centre the gradient vanishes: no projection from there.
  const TriangleMesh mesh = sample_meshes::mesh({{20, 20, 20}, {20, 20, 20}, {20, 20, 20}}, {{0, 1, 2}});
  const DistanceFigures figures = distances_of(mesh, ball());
  EXPECT_GT(figures.unprojected, 0U);
  EXPECT_TRUE(std::isfinite(figures.max));
  EXPECT_GT(figures.max, 1.0);
}

/// The notes of a measurement, which must say nothing of the distance.
std::string notes_without_distance(TriangleMesh mesh) {
  Monitor monitor;
  const Isosurface surface = ball();
  const Measurement measured = measure(mesh, MeasuredAgainst{&surface, nullptr}, monitor);
  for (const char* figure : {"distance_mean", "distance_max", "distance_vertex_max", "distance_max_voxels",
                             "normal_angle_mean", "curvature_max", "gradient_max"}) {
    EXPECT_FALSE(measured.figure(figure)) << figure;
  }
  EXPECT_GT(measured.number("distance_unprojected"), 0.0);
  EXPECT_FALSE(mesh.vertex_data.contains("distance"));
  std::string notes;
  for (const std::string& note : monitor.notes()) notes += note + '\n';
  return notes;
}

TEST(Distance, IsNotMeasuredIfNoPointReachesTheSurface) {
  TriangleMesh metres = sphere(12.0, 20);
  EXPECT_TRUE(distances_of(metres, ball()).any_projected());
  for (Eigen::Vector3d& x : metres.vertices) x *= 1e-3;
  const DistanceFigures figures = distances_of(metres, ball());
  EXPECT_EQ(figures.unprojected, figures.points);
  EXPECT_FALSE(figures.any_projected());
  const std::string of_metres = notes_without_distance(metres);
  EXPECT_NE(of_metres.find("distances could not be measured"), std::string::npos) << of_metres;
  EXPECT_NE(of_metres.find("is the mesh in metres? Lengths must be in mm"), std::string::npos) << of_metres;

  TriangleMesh micrometres = sphere(12.0, 20);
  for (Eigen::Vector3d& x : micrometres.vertices) x *= 1e3;
  EXPECT_NE(notes_without_distance(micrometres).find("is the mesh in micrometres?"), std::string::npos);

  TriangleMesh elsewhere = sphere(12.0, 20);
  for (Eigen::Vector3d& x : elsewhere.vertices) x.x() += 200.0;
  Monitor monitor;
  const Isosurface surface = ball();
  // Newton's steps reach the surface from there, so there is a distance.
  EXPECT_GT(measure(elsewhere, MeasuredAgainst{&surface, nullptr}, monitor).number("distance_mean"), 150.0);
  ASSERT_EQ(monitor.notes().size(), 1U);
  EXPECT_NE(monitor.notes()[0].find("the mesh is far from the surface; its bounding box lies outside of the volume"),
            std::string::npos);
  // So do those from the volume's middle, but not from its very centre, where a mesh in metres may lie.
  TriangleMesh inner = sphere(12.0, 20);
  for (Eigen::Vector3d& x : inner.vertices) x = Eigen::Vector3d(20, 20, 25) + 1e-3 * (x - Eigen::Vector3d(20, 20, 20));
  measure(inner, MeasuredAgainst{&surface, nullptr}, monitor);
  ASSERT_EQ(monitor.notes().size(), 2U);
  EXPECT_NE(monitor.notes()[1].find("the mesh is far from the surface; the diagonal"), std::string::npos);
  EXPECT_NE(monitor.notes()[1].find("is the mesh in metres?"), std::string::npos);
}

TEST(Distance, ANoteSaysIfItIsAnEstimateInPart) {
  const auto notes = [](TriangleMesh mesh) {
    Monitor monitor;
    const Isosurface surface = ball();
    const Measurement measured = measure(mesh, MeasuredAgainst{&surface, nullptr}, monitor);
    EXPECT_TRUE(measured.figure("distance_mean"));
    return monitor.notes();
  };
  TriangleMesh inner = sphere(1.0, 20);
  for (Eigen::Vector3d& x : inner.vertices) x -= Eigen::Vector3d(19, 19, 19);  // in the lattice's corner, out of reach
  EXPECT_TRUE(notes(sphere(12.2, 20)).empty());
  const std::vector<std::string> found = notes(sample_meshes::together(sphere(12.2, 20), inner));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].find("distances are estimates in part: Newton's steps do not reach the surface from "), 0U)
      << found[0];
}

TEST(Distance, SameBitsForAnyNumberOfThreads) {
  const TriangleMesh mesh = sphere(12.2, 40);
  const Isosurface surface = ball();
  const DistanceFigures figures = distances_of(mesh, surface);
  for (const std::size_t threads : {1, 2, 4}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const DistanceFigures again = distances_of(mesh, surface);
    EXPECT_EQ(again.mean, figures.mean);
    EXPECT_EQ(again.max, figures.max);
  }
}

}  // namespace

}  // namespace isobench
