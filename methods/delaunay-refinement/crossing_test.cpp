// Crossings of segments with surfaces whose position is known.
#include "isobench/methods/delaunay-refinement/crossing.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/delaunay-refinement/seeds.h"
#include "isobench/methods/lattice/marching_cubes.h"

namespace isobench::delaunay_refinement {
namespace {

/// The plane z = 4.3 in a volume of 10 mm, the object below it. Splines reproduce a linear function.
Isosurface plane() {
  FloatVolume volume;
  volume.lattice.size = {11, 11, 11};
  for (int k = 0; k < 11; ++k) volume.samples.insert(volume.samples.end(), 121, static_cast<float>(k));
  return {std::move(volume), 4.3, Inside::below};
}

TEST(Crossing, OfAPlane) {
  const Isosurface surface = plane();
  for (const auto& [a, b] : {std::pair<Eigen::Vector3d, Eigen::Vector3d>{{5, 5, 1}, {5, 5, 9}},
                             {{2, 3, 9.9}, {8, 3, 0.1}},
                             {{5, 5, 4.29}, {5, 5, 4.31}}}) {
    const auto x = crossing(surface, a, b);
    ASSERT_TRUE(x);
    EXPECT_NEAR(x->z(), 4.3, 2e-6);
    EXPECT_LT((b - a).normalized().cross(*x - a).norm(), 1e-9) << "not on the segment";
    EXPECT_LT((*crossing(surface, b, a) - *x).norm(), 1e-5);
  }
  EXPECT_FALSE(crossing(surface, {5, 5, 5}, {1, 2, 9}));
  EXPECT_FALSE(crossing(surface, {5, 5, 1}, {1, 2, 3}));
}

// Circumcentres may be anywhere. A spline has values beyond its lattice, but the object ends there.
TEST(Crossing, WhatIsFarOutsideTheVolumeIsOutsideTheObject) {
  const Isosurface surface = plane();
  EXPECT_TRUE(is_inside(surface, {5, 5, 1}));
  EXPECT_FALSE(is_inside(surface, {5, 5, -1e-9}));
  EXPECT_FALSE(is_inside(surface, {1e12, 5, 1}));
  const auto above = crossing(surface, {5, 5, 1}, {5, 5, 1e12});
  ASSERT_TRUE(above);
  EXPECT_NEAR(above->z(), 4.3, 2e-6);
  const auto below = crossing(surface, {5, 5, 1}, {5, 5, -1e12});
  ASSERT_TRUE(below);
  EXPECT_NEAR(below->z(), 0.0, 1e-12) << "where the object leaves the volume, but for rounding";
  const double infinite = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(crossing(surface, {5, 5, 1}, {5, 5, infinite}));
  EXPECT_FALSE(crossing(surface, {5, 5, 1}, {5, nan, 9}));
}

TEST(Crossing, OfATorusIsOnIt) {
  const Isosurface surface(sample_phantom(phantom("torus"), 40), 0.0);
  const Eigen::Vector3d low = 0.1 * surface.extent(), high = 0.9 * surface.extent();
  int found = 0;
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 20; ++j) {
      const Eigen::Vector3d a(low[0] + (high[0] - low[0]) * i / 19.0, low[1] + (high[1] - low[1]) * j / 19.0, low[2]);
      const Eigen::Vector3d b = {a[0], a[1], 0.5 * surface.extent()[2]};
      const auto x = crossing(surface, a, b);
      EXPECT_EQ(x.has_value(), is_inside(surface, a) != is_inside(surface, b));
      if (!x) continue;
      ++found;
      EXPECT_LT(std::abs(surface.value(*x)), 1e-5 * surface.voxel());
    }
  }
  EXPECT_GT(found, 50);
}

TEST(DelaunayRefinementSeeds, StandOnEveryComponentAndApart) {
  const Isosurface surface(sample_phantom(phantom("two-spheres"), 40), 0.0);
  Monitor monitor;
  const TriangleMesh lattice_mesh = marching_cubes(surface, monitor);
  const double spacing = 0.2 * surface.extent()[0];
  const std::vector<Eigen::Vector3d> seeds = seeds_on(lattice_mesh, spacing, 1);
  EXPECT_EQ(seeds, seeds_on(lattice_mesh, spacing, 1));
  EXPECT_NE(seeds, seeds_on(lattice_mesh, spacing, 2));
  EXPECT_GE(seeds.size(), 16U);
  const double middle = 0.5 * surface.extent()[0];
  const auto left = std::count_if(seeds.begin(), seeds.end(), [&](const auto& x) { return x[0] < middle; });
  EXPECT_GE(left, 8);
  EXPECT_GE(static_cast<std::ptrdiff_t>(seeds.size()) - left, 8);
  EXPECT_LE(seeds_on(lattice_mesh, 0.0, 1).size(), 400U);
}

}  // namespace
}  // namespace isobench::delaunay_refinement
