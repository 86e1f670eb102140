#include "isobench/datasets/samples.h"

#include <gtest/gtest.h>

namespace isobench {
namespace {

constexpr SampleType all_types[] = {SampleType::u8,  SampleType::i8,  SampleType::u16, SampleType::i16,
                                    SampleType::u32, SampleType::i32, SampleType::f32, SampleType::f64,
                                    SampleType::i64, SampleType::u64};

TEST(Samples, HaveTheTypeThatTheyAreMadeWith) {
  for (const SampleType type : all_types) {
    const Samples none(type);
    EXPECT_EQ(none.type(), type) << to_string(type);
    EXPECT_TRUE(none.empty());
  }
  EXPECT_EQ(Samples(std::vector<std::int16_t>{-7, 3}).type(), SampleType::i16);
  EXPECT_EQ(Samples(std::vector<double>{0.1}).as<double>().front(), 0.1);
  EXPECT_EQ(Samples(std::vector<float>(12)).size(), 12U);
}

TEST(Samples, TakeTheBytesOfTheirTypeAndNoMore) {
  for (const SampleType type : all_types) {
    Samples samples(type);
    samples.visit([](auto& values) { values.resize(1000); });
    const std::size_t taken = samples.visit([](const auto& values) { return values.capacity() * sizeof(values[0]); });
    EXPECT_EQ(taken, 1000 * bytes_of(type)) << to_string(type);
  }
  EXPECT_EQ(bytes_of(SampleType::u8), 1U);
  EXPECT_EQ(bytes_of(SampleType::i16), 2U);
  EXPECT_EQ(bytes_of(SampleType::f32), 4U);
  EXPECT_EQ(bytes_of(SampleType::i64), 8U);
}

TEST(Samples, OfTwoTypesAreNotEqual) {
  EXPECT_EQ(Samples(std::vector<std::int32_t>{1, 2}), Samples(std::vector<std::int32_t>{1, 2}));
  EXPECT_FALSE(Samples(std::vector<std::int32_t>{1, 2}) == Samples(std::vector<std::int32_t>{1, 3}));
  EXPECT_FALSE(Samples(std::vector<std::int32_t>{1, 2}) == Samples(std::vector<std::uint32_t>{1, 2}));
}

TEST(Samples, RealOfATypeHoldsItsValues) {
  EXPECT_TRUE((std::is_same_v<RealOf<std::uint16_t>, float>));
  EXPECT_TRUE((std::is_same_v<RealOf<std::int8_t>, float>));
  EXPECT_TRUE((std::is_same_v<RealOf<float>, float>));
  EXPECT_TRUE((std::is_same_v<RealOf<std::int32_t>, double>));
  EXPECT_TRUE((std::is_same_v<RealOf<double>, double>));
}

}  // namespace
}  // namespace isobench
