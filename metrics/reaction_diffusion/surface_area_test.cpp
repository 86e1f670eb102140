// Areas from volumes, against closed forms.
#include "isobench/metrics/reaction_diffusion/surface_area.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "isobench/metrics/test_surfaces.h"

namespace isobench {
namespace {

TEST(SurfaceArea, OfAPlaneOnAnUnevenLattice) {
  // Border nodes are left out: 19 × 9 cells of 1 mm × 2 mm.
  EXPECT_NEAR(surface_area(plane()), 19.0 * 18.0, 1e-9);
}

TEST(SurfaceArea, OfABall) {
  // The spline is 0.03 mm within the sphere of radius 12.
  EXPECT_NEAR(surface_area(ball()) / (4.0 * M_PI * 11.97 * 11.97), 1.0, 5e-3);
}

TEST(SurfaceArea, OfATiltedPlaneOnAnUnevenLattice) {
  // 3 x + 4 z = 60: it meets the borders at z = 15 and z = 7.5 and rises over x with the slope −3/4.
  FloatVolume volume;
  volume.lattice.size = {11, 9, 41};
  volume.lattice.spacing = {1.0, 2.0, 0.5};
  for (int k = 0; k < 41; ++k) {
    for (int j = 0; j < 9; ++j) {
      for (int i = 0; i < 11; ++i) volume.samples.push_back(static_cast<float>(3.0 * i + 2.0 * k));
    }
  }
  // 9 × 7 cells of 1 mm × 2 mm without the border, over the cosine of the slope. Columns of nodes have 0.96 and 1.04
  // times their share by turns, and there is one more of the former.
  EXPECT_NEAR(surface_area(Isosurface(std::move(volume), 60.0, Inside::below)) / (9.0 * 14.0 * 1.25), 1.0, 0.01);
}

TEST(SurfaceArea, SameBitsForAnyNumberOfThreads) {
  const Isosurface surface = ball();
  const double expected = surface_area(surface);
  for (const std::size_t threads : {1, 2, 4}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    EXPECT_EQ(surface_area(surface), expected);
  }
}

}  // namespace
}  // namespace isobench
