// Distance from the surface to a mesh, against closed forms.
#include "isobench/metrics/distance_from_surface/distance_from_surface.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <numbers>

#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/metrics/test_surfaces.h"

namespace isobench {
namespace {

/// A rectangle over 0…`width` in x and all of the plane in y.
TriangleMesh rectangle(double width, double z) {
  return sample_meshes::mesh({{0, 0, z}, {width, 0, z}, {width, 20, z}, {0, 20, z}}, {{0, 1, 2}, {0, 2, 3}});
}

TEST(DistanceFromSurface, ConstantOffsetFromAPlane) {
  Monitor monitor;
  const DistanceFromSurface figures = measure_distance_from_surface(rectangle(20.0, 10.55), plane(), monitor);
  EXPECT_NEAR(figures.mean, 0.3, 1e-6);
  EXPECT_NEAR(figures.max, 0.3, 1e-6);
}

// The distance of this mesh to the surface is 0. That of the surface to the mesh is linear on both sides of the lattice
// line where the mesh ends, so its mean is exact: (0 · 10 + 5 · 10)/20.
TEST(DistanceFromSurface, SeesWhatIsMissing) {
  Monitor monitor;
  const DistanceFromSurface figures = measure_distance_from_surface(rectangle(10.0, 10.25), plane(), monitor);
  EXPECT_NEAR(figures.mean, 2.5, 1e-6);
  EXPECT_NEAR(figures.max, 10.0, 1e-6);
}

// A cube in a ball of radius r: the sphere is farthest over the middle of a face, by r(1 − 1/√3). The spline moves the
// surface inwards by voxel²/(3r) = 0.028 mm. Half a voxel from the middle the distance is 0.01 mm smaller.
TEST(DistanceFromSurface, CubeInABall) {
  const double half = 12.0 / std::numbers::sqrt3;
  const TriangleMesh cube =
      sample_meshes::box(Eigen::Vector3d::Constant(20.0 - half), Eigen::Vector3d::Constant(20.0 + half));
  Monitor monitor;
  EXPECT_NEAR(measure_distance_from_surface(cube, ball(), monitor).max, 12.0 - half, 0.04);
}

TEST(DistanceFromSurface, AMeshWithoutAreaIsAsFarAsTheVolumeIsLong) {
  const TriangleMesh needle = sample_meshes::mesh({{1, 1, 1}, {2, 2, 2}, {3, 3, 3}}, {{0, 1, 2}});
  Monitor monitor;
  const DistanceFromSurface figures = measure_distance_from_surface(needle, ball(), monitor);
  EXPECT_DOUBLE_EQ(figures.mean, ball().extent().norm());
  EXPECT_DOUBLE_EQ(figures.max, ball().extent().norm());
}

TEST(DistanceFromSurface, IsTheSameForAnyNumberOfThreads) {
  const TriangleMesh cube = sample_meshes::box(Eigen::Vector3d::Constant(12.0), Eigen::Vector3d::Constant(28.0));
  Monitor monitor;
  const DistanceFromSurface figures = measure_distance_from_surface(cube, ball(), monitor);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const DistanceFromSurface again = measure_distance_from_surface(cube, ball(), monitor);
  EXPECT_EQ(figures.mean, again.mean);
  EXPECT_EQ(figures.max, again.max);
}

}  // namespace
}  // namespace isobench
