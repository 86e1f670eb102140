#include "methods/cvt/sizes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "methods/particles/random.h"

namespace isobench::cvt {
namespace {

Eigen::Vector3d somewhere(std::uint64_t n) {
  return 20.0 * Eigen::Vector3d(particles::uniform(5, n, 0), particles::uniform(5, n, 1), particles::uniform(5, n, 2));
}

TEST(CvtSizes, AreTheFieldsWhereNothingIsRefined) {
  const SizingField field(2.0);
  const particles::Spacing spacing{field, 1.6};
  EXPECT_EQ(Sizes(spacing)({1.0, 2.0, 3.0}), 1.25);
}

TEST(CvtSizes, ShrinkNearRefinedPlacesAndGrowAwayFromThem) {
  const SizingField field(1.0);
  const particles::Spacing spacing{field, 1.0};
  Sizes sizes(spacing);
  const Eigen::Vector3d centre(7.0, 8.0, 9.0);
  sizes.refine({centre});
  for (double away = 0.0; away < 5.0; away += 0.1) {
    const double wanted = std::min(1.0, 0.7 + 0.3 * std::max(0.0, away - 1.2));
    EXPECT_NEAR(sizes(centre + away * Eigen::Vector3d(0.6, 0.0, -0.8)), wanted, 1e-12) << away;
  }
  // Again, and it shrinks again.
  sizes.refine({centre});
  EXPECT_NEAR(sizes(centre), 0.49, 1e-12);
}

TEST(CvtSizes, AreTheLeastOverAllRefinedPlacesAndSlopeNoMoreThanAsked) {
  const SizingField field(1.5);
  const particles::Spacing spacing{field, 1.0};
  Sizes sizes(spacing);
  std::vector<Eigen::Vector3d> centres;
  for (std::uint64_t n = 0; n < 40; ++n) centres.push_back(somewhere(n));
  sizes.refine(centres);
  for (std::uint64_t n = 0; n < 2000; ++n) {
    const Eigen::Vector3d x = somewhere(100 + n);
    double wanted = 1.5;
    for (const Eigen::Vector3d& centre : centres) {
      wanted = std::min(wanted, 1.05 + 0.3 * std::max(0.0, (x - centre).norm() - 1.8));
    }
    EXPECT_NEAR(sizes(x), wanted, 1e-12);
  }
}

}  // namespace
}  // namespace isobench::cvt
