#include "isobench/datasets/volume.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "isobench/foundation/error.h"

namespace isobench {
namespace {

Lattice oblique_lattice() {
  Lattice lattice;
  lattice.size = {4, 3, 2};
  lattice.spacing = {0.5, 1.0, 4.0};
  lattice.origin = {10.0, -20.0, 30.0};
  lattice.direction = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  return lattice;
}

Volume row_of(Samples samples) {
  Volume volume;
  volume.lattice.size = {static_cast<int>(samples.size()), 1, 1};
  volume.samples = std::move(samples);
  return volume;
}

TEST(Volume, FloatsAreMovedAndOthersRounded) {
  std::vector<float> floats = {0.25F, -3.0F};
  const float* address = floats.data();
  EXPECT_EQ(as_float(row_of(std::move(floats))).samples.data(), address);
  EXPECT_EQ(as_float(row_of(std::vector<std::uint8_t>{0, 255})).samples, (std::vector<float>{0.0F, 255.0F}));
  EXPECT_EQ(as_float(row_of(std::vector<std::int32_t>{16777217})).samples, std::vector<float>{16777216.0F});
  EXPECT_EQ(as_float(row_of(std::vector<double>{0.1})).samples, std::vector<float>{0.1F});
  EXPECT_EQ(as_real<double>(row_of(std::vector<std::int32_t>{16777217})).samples, std::vector<double>{16777217.0});
}

TEST(Volume, NeedsDoubleWhereAFloatWouldRound) {
  EXPECT_FALSE(needs_double(row_of(std::vector<std::uint16_t>{65535})));
  EXPECT_FALSE(needs_double(row_of(std::vector<std::int32_t>{16777216, -1})));
  EXPECT_TRUE(needs_double(row_of(std::vector<std::int32_t>{16777217})));
  EXPECT_TRUE(needs_double(row_of(std::vector<std::uint64_t>{std::numeric_limits<std::uint64_t>::max()})));
  EXPECT_FALSE(needs_double(row_of(std::vector<double>{0.5, std::numeric_limits<double>::quiet_NaN()})));
  EXPECT_TRUE(needs_double(row_of(std::vector<double>{0.1})));
}

TEST(Lattice, NumbersNodesWithXFastest) {
  const Lattice lattice = oblique_lattice();
  EXPECT_EQ(lattice.nodes(), 24U);
  std::size_t n = 0;
  for (int k = 0; k < 2; ++k) {
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 4; ++i) EXPECT_EQ(lattice.index(i, j, k), n++);
    }
  }
}

TEST(Lattice, CountsMoreNodesThanAnIntHolds) {
  Lattice lattice;
  lattice.size = {2048, 2048, 2048};
  EXPECT_EQ(lattice.nodes(), std::size_t{1} << 33U);
  EXPECT_EQ(lattice.index(2047, 2047, 2047), lattice.nodes() - 1);
}

TEST(Lattice, AVoxelIsTheGeometricMeanOfTheSpacing) { EXPECT_NEAR(oblique_lattice().voxel(), std::cbrt(2.0), 1e-15); }

TEST(Lattice, ToLocalUndoesToWorld) {
  const Lattice lattice = oblique_lattice();
  const Eigen::Vector3d local(1.25, -2.0, 7.5);
  EXPECT_TRUE(lattice.to_world(Eigen::Vector3d::Zero()).isApprox(lattice.origin));
  EXPECT_TRUE(lattice.to_local(lattice.to_world(local)).isApprox(local, 1e-12));
  // One step along i in the lattice is one step along the first column in the world.
  const Eigen::Vector3d step = lattice.to_world({0.5, 0, 0}) - lattice.origin;
  EXPECT_TRUE(step.isApprox(0.5 * lattice.direction.col(0)));
}

TEST(Lattice, KnowsItsHandedness) {
  Lattice lattice = oblique_lattice();
  EXPECT_TRUE(lattice.right_handed());
  lattice.direction.col(1) *= -1.0;
  EXPECT_FALSE(lattice.right_handed());
}

FloatVolume ramp() {
  FloatVolume volume;
  volume.lattice = oblique_lattice();
  for (std::size_t n = 0; n < volume.lattice.nodes(); ++n) volume.samples.push_back(static_cast<float>(n) - 5.0F);
  return volume;
}

TEST(Volume, AtIsTheSampleOfTheNode) {
  FloatVolume volume = ramp();
  EXPECT_EQ(volume.at(1, 2, 1), -5.0F + 12.0F + 8.0F + 1.0F);
  volume.at(1, 2, 1) = 99.0F;
  EXPECT_EQ(volume.samples[21], 99.0F);
}

TEST(Volume, RangeIsOfAllSamples) {
  const Range range = sample_range(ramp());
  EXPECT_EQ(range.min, -5.0F);
  EXPECT_EQ(range.max, 18.0F);
}

TEST(Volume, RangeNamesTheNodeThatIsNotFinite) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    FloatVolume volume = ramp();
    volume.at(3, 1, 1) = bad;
    try {
      sample_range(volume);
      FAIL() << "no error for " << bad;
    } catch (const DataError& error) {
      EXPECT_NE(std::string(error.what()).find("(3, 1, 1)"), std::string::npos) << error.what();
    }
  }
}

TEST(Volume, OfEveryTypeBecomesFloats) {
  Volume volume = ramp();
  volume.samples = std::vector<std::int32_t>(24, 312782574);
  const FloatVolume floats = as_float(volume);
  EXPECT_EQ(floats.samples, std::vector<float>(24, 312782560.0F));
  EXPECT_EQ(floats.lattice.size, volume.lattice.size);
  EXPECT_EQ(sample_range(volume).max, 312782574.0);
  EXPECT_EQ(range_text(volume), "[312782574, 312782574]");
}

TEST(Volume, OfFloatsIsMovedThereAndBack) {
  FloatVolume floats = ramp();
  const float* address = floats.samples.data();
  Volume volume = std::move(floats);
  EXPECT_EQ(as_float(std::move(volume)).samples.data(), address);
}

TEST(Volume, ADoubleThatNoFloatCanHoldIsNamed) {
  Volume volume = ramp();
  std::vector<double> samples(24, 0.5);
  samples[21] = 1e200;
  volume.samples = samples;
  EXPECT_NO_THROW(check_finite(volume));
  try {
    as_float(volume);
    FAIL() << "no error for 1e200";
  } catch (const DataError& error) {
    EXPECT_NE(std::string(error.what()).find("(1, 2, 1) is 1e+200"), std::string::npos) << error.what();
  }
  samples[21] = std::numeric_limits<double>::quiet_NaN();
  volume.samples = samples;
  EXPECT_THROW(check_finite(volume), DataError);
}

TEST(Volume, RangeOfNothingIsAnError) { EXPECT_THROW(sample_range(Volume{}), DataError); }

}  // namespace
}  // namespace isobench
