// Preparation steps on samples of every type: they compare exactly and keep the type where they can.
#include <gtest/gtest.h>

#include <limits>

#include "isobench/datasets/preparation/prepare.h"
#include "isobench/foundation/error.h"

namespace isobench {
namespace {

template <class T>
Volume row(const std::vector<T>& samples) {
  Volume volume;
  volume.lattice.size = {static_cast<int>(samples.size()), 1, 1};
  volume.samples = samples;
  return volume;
}

Samples prepared(Volume volume, const PrepareStep& step) {
  Monitor monitor;
  return prepare(std::move(volume), {step}, monitor).samples;
}

using Bytes = std::vector<std::uint8_t>;
constexpr std::int64_t beyond_double = (std::int64_t{1} << 53) + 1;  // the double nearest to it is another number
constexpr std::int64_t least_i64 = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t most_i64 = std::numeric_limits<std::int64_t>::max();
constexpr std::uint64_t most_u64 = std::numeric_limits<std::uint64_t>::max();

TEST(PrepareLabels, AreComparedAsTheIntegersThatTheyAre) {
  // Both round to the float 312782560.
  const std::vector<std::int32_t> near = {312782546, 312782574, 312782560, 0};
  EXPECT_EQ(prepared(row(near), SelectLabels{{312782546}}), Samples(Bytes{1, 0, 0, 0}));
  EXPECT_EQ(prepared(row(near), SelectLabels{{312782574}}), Samples(Bytes{0, 1, 0, 0}));
  const std::vector<std::int64_t> wide = {beyond_double, beyond_double - 1, least_i64, most_i64};
  EXPECT_EQ(prepared(row(wide), SelectLabels{{beyond_double}}), Samples(Bytes{1, 0, 0, 0}));
  EXPECT_EQ(prepared(row(wide), SelectLabels{{least_i64, most_i64}}), Samples(Bytes{0, 0, 1, 1}));
  const std::vector<std::uint64_t> positive = {std::uint64_t{beyond_double}, most_u64, 7, 0};
  EXPECT_EQ(prepared(row(positive), SelectLabels{{beyond_double, 7}}), Samples(Bytes{1, 0, 1, 0}));
}

TEST(PrepareLabels, OutsideTheTypeSelectNothing) {
  // As an 8-bit integer 300 would be 44, −1 would be 255.
  EXPECT_EQ(prepared(row(Bytes{44, 255, 1}), SelectLabels{{300, -1, 1}}), Samples(Bytes{0, 0, 1}));
  EXPECT_THROW(prepared(row(Bytes{44, 255, 1}), SelectLabels{{300, -1}}), DataError);
  EXPECT_THROW(prepared(row(std::vector<std::uint64_t>{most_u64, 0}), SelectLabels{{-1}}), DataError);
  // A float is compared exactly, too: none is 312782546.
  EXPECT_THROW(prepared(row(std::vector<float>{312782560.0F}), SelectLabels{{312782546}}), DataError);
  EXPECT_THROW(prepared(row(std::vector<double>{9223372036854775808.0}), SelectLabels{{most_i64}}), DataError);
  EXPECT_EQ(prepared(row(std::vector<float>{3.0F, 3.5F, -2.0F}), SelectLabels{{3, -2}}), Samples(Bytes{1, 0, 1}));
}

TEST(PrepareThreshold, ComparesExactlyAndGivesBytes) {
  EXPECT_EQ(prepared(row(Bytes{0, 1, 2, 255}), Threshold{0.5}), Samples(Bytes{0, 1, 1, 1}));
  EXPECT_EQ(prepared(row(Bytes{0, 1, 2, 255}), Threshold{-4.0}), Samples(Bytes{1, 1, 1, 1}));
  EXPECT_THROW(prepared(row(Bytes{0, 1, 2, 255}), Threshold{256.0}), DataError);
  EXPECT_EQ(prepared(row(std::vector<std::int8_t>{-3, -2, 0}), Threshold{-2.5}), Samples(Bytes{0, 1, 1}));
  const std::vector<std::int64_t> wide = {beyond_double - 2, beyond_double - 1, beyond_double};
  EXPECT_EQ(prepared(row(wide), Threshold{9007199254740992.0}), Samples(Bytes{0, 1, 1}));  // 2^53
  EXPECT_THROW(prepared(row(std::vector<std::int64_t>{most_i64}), Threshold{9223372036854775808.0}), DataError);
  EXPECT_EQ(prepared(row(std::vector<std::uint64_t>{most_u64, 0}), Threshold{9223372036854775808.0}),
            Samples(Bytes{1, 0}));
  // The float nearest to 0.1 is above the double nearest to 0.1.
  EXPECT_EQ(prepared(row(std::vector<double>{0.1, 0.1F}), Threshold{0.1F}), Samples(Bytes{0, 1}));
}

TEST(PrepareThreshold, SaysTheRangeInTheSamplesOwnType) {
  try {
    prepared(row(std::vector<std::int64_t>{beyond_double, beyond_double + 1}), SelectLabels{{5}});
    ADD_FAILURE();
  } catch (const DataError& error) {
    EXPECT_NE(std::string(error.what()).find("[9007199254740993, 9007199254740994]"), std::string::npos)
        << error.what();
  }
}

TEST(PrepareTypes, StepsThatMoveNodesKeepTheType) {
  const std::vector<std::int64_t> wide = {0, 0, beyond_double, 0, 1, 0};
  EXPECT_EQ(prepared(row(wide), Crop{}), Samples(std::vector<std::int64_t>{beyond_double, 0, 1}));
  Monitor monitor;
  const Volume padded = prepare(row(wide), {Pad{1, 5.0}}, monitor);
  ASSERT_EQ(padded.samples.type(), SampleType::i64);
  EXPECT_EQ(padded.samples.as<std::int64_t>()[padded.lattice.index(3, 1, 1)], beyond_double);
  EXPECT_EQ(padded.samples.as<std::int64_t>().front(), 5);
  EXPECT_EQ(prepared(row(wide), LargestComponent{}), Samples(std::vector<std::int64_t>{0, 0, beyond_double, 0, 0, 0}));
  EXPECT_EQ(prepared(row(Bytes{9, 0, 3, 0, 0, 0}), LargestComponent{}), Samples(Bytes{9, 0, 0, 0, 0, 0}));
  EXPECT_EQ(prepared(row(Bytes{9, 8, 7, 6, 5, 4}), CloseBorder{9.5}), Samples(Bytes{9, 8, 7, 6, 5, 4}));
  EXPECT_EQ(prepared(row(Bytes{1, 0, 1}), CloseBorder{0.5}).type(), SampleType::u8);
}

TEST(PrepareTypes, AValueThatTheTypeCannotHoldMakesRealNumbers) {
  EXPECT_EQ(prepared(row(Bytes{9, 0, 9}), CloseBorder{2.0}).type(), SampleType::f32);  // closed by −5
  EXPECT_EQ(prepared(row(Bytes{9}), Pad{1, -1.0}).type(), SampleType::f32);
  EXPECT_EQ(prepared(row(Bytes{9}), Pad{1, 256.0}).type(), SampleType::f32);
  EXPECT_EQ(prepared(row(Bytes{9}), Pad{1, 255.0}).type(), SampleType::u8);
  const Samples wide = prepared(row(std::vector<std::int32_t>{312782546}), Pad{1, -0.5});
  ASSERT_EQ(wide.type(), SampleType::f64);  // a float cannot hold the label
  EXPECT_EQ(wide.as<double>()[13], 312782546.0);
}

TEST(PrepareTypes, StepsThatComputeGiveTheFloatsThatTheyGiveOfFloats) {
  Volume bytes;
  bytes.lattice.size = {6, 5, 4};
  Bytes samples;
  for (int n = 0; n < 120; ++n) samples.push_back(static_cast<std::uint8_t>(n * 37 % 251 < 100 ? 0 : n));
  bytes.samples = samples;
  const FloatVolume floats = as_float(bytes);
  for (const PrepareStep& step :
       std::vector<PrepareStep>{SignedDistance{}, Gaussian{{1.0, 0.7, 2.0}}, Subsample{2}, Resample{{0.7, 0.6, 1.0}}}) {
    const Samples result = prepared(bytes, step);
    EXPECT_EQ(result.type(), SampleType::f32) << describe(step);
    EXPECT_EQ(result, prepared(floats, step)) << describe(step);
  }
}

}  // namespace
}  // namespace isobench
