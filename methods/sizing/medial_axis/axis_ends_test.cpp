#include "isobench/methods/sizing/medial_axis/axis_ends.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/lattice/marching_cubes.h"

namespace isobench {
namespace {

/// The samples of a phantom and the ends of its axis.
struct Ends {
  Isosurface surface;
  SurfaceSamples samples;
  MedialBalls found;

  explicit Ends(const std::string& name, int nodes = 48) : surface(sample_phantom(phantom(name), nodes), 0.0) {
    Monitor monitor;
    samples = surface_samples(surface, marching_cubes(surface, monitor).vertices);
    found = axis_ends(samples, 0.5 * surface.extent().minCoeff(), monitor);
  }
};

TEST(AxisEnds, OfASphereAreItsCentre) {
  const Ends ends("sphere");
  ASSERT_FALSE(ends.found.centres.empty());
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& x : ends.samples.points) middle += x / static_cast<double>(ends.samples.points.size());
  for (const Eigen::Vector3d& centre : ends.found.centres) {
    // The curvature of the spline differs by half a percent from the curvature of the sphere of 20 mm.
    ASSERT_LT((centre - middle).norm(), 0.01 * 20.0);
  }
}

// For semi-axes a > b > c, the axis is an elliptic disc in z = 0 with semi-axes (a² − c²)/a and (b² − c²)/b. Its rim is
// where it ends; no point within the disc is an end.
TEST(AxisEnds, OfAnEllipsoidAreTheRimOfItsAxis) {
  const Ends ends("ellipsoid");
  const double a = (24.0 * 24.0 - 12.0 * 12.0) / 24.0;
  const double b = (16.0 * 16.0 - 12.0 * 12.0) / 16.0;
  std::vector<Eigen::Vector3d> rim;
  for (double turn = 0.0; turn < 6.283; turn += 0.01) rim.emplace_back(a * std::cos(turn), b * std::sin(turn), 0.0);
  const auto distance = [](const Eigen::Vector3d& x, const std::vector<Eigen::Vector3d>& points) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& y : points) nearest = std::min(nearest, (y - x).norm());
    return nearest;
  };
  std::vector<Eigen::Vector3d> found;
  for (const Eigen::Vector3d& x : ends.found.centres) found.push_back(ends.surface.lattice().to_world(x));
  double off = 0.0;
  for (const Eigen::Vector3d& x : found) off = std::max(off, distance(x, rim));
  double gap = 0.0;
  for (const Eigen::Vector3d& x : rim) gap = std::max(gap, distance(x, found));
  RecordProperty("off", std::to_string(off / ends.surface.voxel()));
  RecordProperty("gap", std::to_string(gap / ends.surface.voxel()));
  // Samples are almost a voxel apart, so a ball next to the ridge may contain no sample although it crosses the
  // surface.
  EXPECT_LE(off, 0.5 * ends.surface.voxel());
  EXPECT_LE(gap, 1.5 * ends.surface.voxel());
}

// The axis between the two spheres extends to infinity and has no end. The axis of each sphere is a point.
TEST(AxisEnds, AreNoneBetweenTwoSpheres) {
  const Ends ends("two-spheres");
  ASSERT_FALSE(ends.found.radii.empty());
  for (const double radius : ends.found.radii) EXPECT_NEAR(radius, 10.0, 0.5 * ends.surface.voxel());
}

TEST(AxisEnds, AreTheSameForAnyNumberOfThreads) {
  const auto with_threads = [](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return Ends("ellipsoid", 40).found;
  };
  const MedialBalls one = with_threads(1);
  const MedialBalls four = with_threads(4);
  ASSERT_FALSE(one.centres.empty());
  EXPECT_EQ(one.centres, four.centres);
  EXPECT_EQ(one.radii, four.radii);
}

}  // namespace
}  // namespace isobench
