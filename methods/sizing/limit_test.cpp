#include "isobench/methods/sizing/limit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "isobench/datasets/phantoms/phantoms.h"

namespace isobench {
namespace {

/// A field without symmetry: two frequencies and a ridge, with values between 0.6 and 9 voxels.
std::vector<float> bumpy_field(const Band& band) {
  std::vector<float> h(band.size());
  for (std::size_t n = 0; n < band.size(); ++n) {
    const Eigen::Vector3d x = band.position(n);
    const double value = 3.0 + 2.0 * std::sin(0.9 * x[0] + 0.3 * x[1]) + 1.4 * std::cos(0.7 * x[2] - 0.5 * x[1]) +
                         2.0 * std::abs(std::sin(0.31 * (x[0] - x[2])));
    h[n] = static_cast<float>(std::max(0.6, value));
  }
  return h;
}

Isosurface small_surface(const std::string& name, const Eigen::Vector3d& stretch) {
  FloatVolume volume = sample_phantom(phantom(name), 24);
  // Voxels of about one unit, so that the field varies over a few nodes.
  volume.lattice.spacing = stretch;
  return Isosurface(std::move(volume), 0.0);
}

class LimiterOf : public testing::TestWithParam<double> {};

// The tolerance 1e-4 is the distance that remains when no step changes a node by more than 1e-7 of its value.
TEST_P(LimiterOf, HasTheFixedPointOfTheExplicitIteration) {
  for (const Eigen::Vector3d& spacing : {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(0.7, 1.0, 1.9)}) {
    const Isosurface surface = small_surface("torus", spacing);
    const Band band(surface, 2);
    const std::vector<float> h0 = bumpy_field(band);
    Monitor monitor;
    const std::vector<float> fast = limit_gradient(band, h0, GetParam(), monitor);
    const std::vector<float> slow = iterate_limit(band, h0, GetParam(), 1e-7, monitor);
    std::size_t limited = 0;
    for (std::size_t n = 0; n < band.size(); ++n) {
      ASSERT_NEAR(fast[n] / slow[n], 1.0, 1e-4) << "node " << n;
      limited += fast[n] < h0[n] ? 1 : 0;
    }
    EXPECT_GT(limited, band.size() / 10);
  }
}

TEST_P(LimiterOf, BoundsTheUpwindGradientAndNeverRaises) {
  const Isosurface surface = small_surface("rounded-box", {1.0, 1.0, 1.0});
  const Band band(surface, 2);
  const std::vector<float> h0 = bumpy_field(band);
  Monitor monitor;
  const std::vector<float> h = limit_gradient(band, h0, GetParam(), monitor);
  for (std::size_t n = 0; n < band.size(); ++n) {
    EXPECT_LE(h[n], h0[n]);
    EXPECT_LE(upwind_gradient_norm(band, h, n), GetParam() * (1.0 + 1e-3));
  }
}

INSTANTIATE_TEST_SUITE_P(Deltas, LimiterOf, testing::Values(0.1, 0.3, 0.5), [](const auto& chosen) {
  return "delta_0" + std::to_string(static_cast<int>(10 * chosen.param));
});

}  // namespace
}  // namespace isobench
