// Tests of the phantoms whose parts come close to each other. phantoms_test.cpp tests what holds for all phantoms.
#include <gtest/gtest.h>

#include "isobench/datasets/isosurface.h"
#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/foundation/error.h"

namespace isobench {
namespace {

using Eigen::Vector3d;

TEST(PhantomParameters, ChooseGapAndThickness) {
  const Phantom sheets = phantom("thin-sheets", {{"thickness", 3.0}, {"gap", 2.5}});
  EXPECT_NEAR(sheets.function({0.0, 0.0, 1.25}), 0.0, 1e-12);
  EXPECT_NEAR(sheets.function({5.0, 0.0, -4.25}), 0.0, 1e-12);
  EXPECT_EQ(sheets.half_extent, Vector3d(19.5, 19.5, 4.25));
  EXPECT_NE(sheets.title.find("2.5 mm apart"), std::string::npos) << sheets.title;
  const Phantom spheres = phantom("near-spheres", {{"gap", 0.3}});
  EXPECT_NEAR(spheres.function({0.15, 0.0, 0.0}), 0.0, 1e-12);
  EXPECT_EQ(phantom("near-spheres", {}).title, phantom("near-spheres").title);
}

TEST(PhantomParameters, UnknownOrImpossibleOnesAreRefused) {
  EXPECT_THROW(phantom("near-spheres", {{"gab", 1.0}}), UsageError);
  EXPECT_THROW(phantom("near-spheres", {{"gap", 0.0}}), UsageError);
  EXPECT_THROW(phantom("near-spheres", {{"gap", std::nan("")}}), UsageError);
  EXPECT_THROW(phantom("sphere", {{"gap", 1.0}}), UsageError);
}

TEST(ThinSheets, FeatureSizeIsHalfOfWhatIsThinner) {
  for (const double gap : {1.0, 2.0, 5.0}) {
    const double thickness = 2.5;
    const Phantom p = phantom("thin-sheets", {{"thickness", thickness}, {"gap", gap}});
    for (const double x : {0.0, 7.0, 17.9}) {
      EXPECT_NEAR(p.feature_size({x, 0.0, 0.5 * gap}), 0.5 * std::min(thickness, gap), 1e-12);
      EXPECT_NEAR(p.feature_size({x, 0.0, -0.5 * gap - thickness}), 0.5 * thickness, 1e-12);
    }
    // Points on the rim lie farther from the plane between the plates.
    EXPECT_NEAR(p.feature_size({18.0 + 0.5 * thickness, 0.0, 0.5 * (gap + thickness)}), 0.5 * thickness, 1e-12);
    EXPECT_EQ(p.smallest_feature, 0.5 * std::min(thickness, gap));
  }
}

TEST(NearSpheres, FeatureSizeFallsToHalfTheGap) {
  const Phantom& p = phantom("near-spheres");
  EXPECT_NEAR(p.feature_size({0.45, 0.0, 0.0}), 0.45, 1e-12);
  EXPECT_NEAR(p.feature_size({20.45, 0.0, 0.0}), 10.0, 1e-12);
  EXPECT_NEAR(p.feature_size({10.45, 10.0, 0.0}), 10.0, 1e-12);
}

// F = |z − z0| − g/2 on a lattice of spacing 1; z0, the middle of the gap, moves from one node to the next.
TEST(PhantomGap, TheSplineKeepsItOpenAboveThirteenTwelfthsOfAVoxel) {
  const double gap = 2.0;
  double highest = -1.0;
  for (int tenth = 0; tenth <= 10; ++tenth) {
    const double middle = 6.0 + 0.1 * tenth;
    FloatVolume v;
    v.lattice.size = {4, 4, 14};
    for (int k = 0; k < 14; ++k) {
      v.samples.insert(v.samples.end(), 16, static_cast<float>(std::abs(k - middle) - 0.5 * gap));
    }
    const Isosurface surface(v, 0.0);
    highest = std::max(highest, surface.value({1.5, 1.5, middle}));
  }
  EXPECT_NEAR(highest, 13.0 / 24.0 - 0.5 * gap, 1e-6);
}

}  // namespace
}  // namespace isobench
