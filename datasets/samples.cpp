#include "isobench/datasets/samples.h"

namespace isobench {

std::size_t bytes_of(SampleType type) {
  switch (type) {
    case SampleType::u8:
    case SampleType::i8:
      return 1;
    case SampleType::u16:
    case SampleType::i16:
      return 2;
    case SampleType::u32:
    case SampleType::i32:
    case SampleType::f32:
      return 4;
    case SampleType::f64:
    case SampleType::i64:
    case SampleType::u64:
      break;
  }
  return 8;
}

std::string to_string(SampleType type) {
  static constexpr const char* names[] = {"u8", "i8", "u16", "i16", "u32", "i32", "f32", "f64", "i64", "u64"};
  return names[static_cast<std::size_t>(type)];
}

Samples::Samples(SampleType type) {
  switch (type) {
    case SampleType::u8:
      values_ = std::vector<std::uint8_t>();
      return;
    case SampleType::i8:
      values_ = std::vector<std::int8_t>();
      return;
    case SampleType::u16:
      values_ = std::vector<std::uint16_t>();
      return;
    case SampleType::i16:
      values_ = std::vector<std::int16_t>();
      return;
    case SampleType::u32:
      values_ = std::vector<std::uint32_t>();
      return;
    case SampleType::i32:
      values_ = std::vector<std::int32_t>();
      return;
    case SampleType::f32:
      values_ = std::vector<float>();
      return;
    case SampleType::f64:
      values_ = std::vector<double>();
      return;
    case SampleType::i64:
      values_ = std::vector<std::int64_t>();
      return;
    case SampleType::u64:
      values_ = std::vector<std::uint64_t>();
      return;
  }
}

std::size_t Samples::size() const {
  return visit([](const auto& values) { return values.size(); });
}

}  // namespace isobench
