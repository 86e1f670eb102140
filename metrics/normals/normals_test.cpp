// Angles between triangles and a plane, and a ball.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/metrics/measurement.h"
#include "isobench/metrics/test_surfaces.h"

namespace isobench {
namespace {

Measurement against(TriangleMesh mesh, const Isosurface& surface) {
  Monitor monitor;
  return measure(mesh, {.surface = &surface}, monitor, MetricChoice::usual);
}

TEST(NormalAngles, OfTiltedTriangles) {
  // z rises by 1 over 10 along y; the second triangle has a quarter of the area and does not tilt.
  const TriangleMesh tilted = sample_meshes::mesh({{5, 5, 10.25}, {15, 5, 10.25}, {5, 15, 11.25}}, {{0, 1, 2}});
  const TriangleMesh level = sample_meshes::mesh({{5, 5, 10.25}, {10, 5, 10.25}, {5, 10, 10.25}}, {{0, 1, 2}});
  const double angle = std::atan(0.1) * 180.0 / std::numbers::pi;
  const Measurement both = against(sample_meshes::together(tilted, level), plane());
  EXPECT_NEAR(both.number("normal_angle_max"), angle, 1e-6);
  const double weight = 50.0 * std::sqrt(1.01);
  EXPECT_NEAR(both.number("normal_angle_mean"), angle * weight / (weight + 12.5), 1e-6);
  TriangleMesh upside_down = tilted;
  std::swap(upside_down.triangles[0][0], upside_down.triangles[0][1]);
  EXPECT_NEAR(against(upside_down, plane()).number("normal_angle_max"), 180.0 - angle, 1e-6);
}

TEST(NormalAngles, TrianglesWithoutAreaOrWithoutANormalDoNotCount) {
  const TriangleMesh flat = sample_meshes::mesh({{5, 5, 10.25}, {15, 5, 10.25}, {10, 5, 10.25}}, {{0, 1, 2}});
  EXPECT_EQ(against(flat, plane()).figure("normal_angle_max"), std::nullopt);
  // Its centroid is the ball's centre, where the gradient vanishes.
  const TriangleMesh central = sample_meshes::mesh({{19, 20, 20}, {20.5, 21, 20}, {20.5, 19, 20}}, {{0, 1, 2}});
  EXPECT_EQ(against(central, ball()).figure("normal_angle_max"), std::nullopt);
}

TEST(NormalAngles, OfASphereFallWithTheEdges) {
  std::vector<double> angles;
  for (const int quartered : {2, 3, 4}) {
    TriangleMesh mesh = sample_meshes::icosphere(quartered);
    for (Eigen::Vector3d& v : mesh.vertices) v = 12.0 * v + Eigen::Vector3d::Constant(20.0);
    angles.push_back(against(mesh, ball()).number("normal_angle_max"));
  }
  EXPECT_NEAR(angles[0] / angles[1], 2.0, 0.2);
  EXPECT_NEAR(angles[1] / angles[2], 2.0, 0.2);
  EXPECT_LT(angles[2], 0.5);
}

}  // namespace
}  // namespace isobench
