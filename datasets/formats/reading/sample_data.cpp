#include "isobench/datasets/formats/reading/sample_data.h"

#include <cstring>
#include <map>
#include <span>
#include <vector>

#include "isobench/datasets/formats/reading/sample_words.h"

namespace isobench {

void convert_samples(const char* bytes, std::size_t count, SampleType type, ByteOrder order, double* numbers) {
  Samples(type).visit([&](const auto& none) {
    using T = SampleOf<decltype(none)>;
    for (std::size_t n = 0; n < count; ++n) {
      numbers[n] = static_cast<double>(number_at<T>(bytes + n * sizeof(T), order));
    }
  });
}

Samples samples_of_bytes(const char* bytes, std::size_t count, SampleType type, ByteOrder order) {
  Samples samples(type);
  samples.visit([&](auto& values) {
    values.resize(count);
    std::memcpy(values.data(), bytes, count * bytes_of(type));
    to_native_order(std::span(values), order);
  });
  return samples;
}

std::optional<Samples> samples_of_text(std::string_view text, std::size_t count, SampleType type) {
  if (text.size() / 2 + 1 < count) return {};  // a digit and a blank each
  Samples samples(type);
  const bool complete = samples.visit([&](auto& values) {
    using T = SampleOf<decltype(values)>;
    values.reserve(count);
    for (std::size_t at = 0; at < text.size();) {
      if (is_blank(text[at])) {
        ++at;
        continue;
      }
      std::size_t end = at;
      while (end < text.size() && !is_blank(text[end])) ++end;
      const std::optional<T> value = number_of_word<T>(text.substr(at, end - at));
      if (!value || values.size() == count) return false;
      values.push_back(*value);
      at = end;
    }
    return values.size() == count;
  });
  return complete ? std::optional(std::move(samples)) : std::nullopt;
}

std::optional<SampleType> sample_type(const std::string& name) {
  static const std::map<std::string, SampleType> names = {{"u8", SampleType::u8},
                                                          {"i8", SampleType::i8},
                                                          {"u16", SampleType::u16},
                                                          {"i16", SampleType::i16},
                                                          {"u32", SampleType::u32},
                                                          {"i32", SampleType::i32},
                                                          {"f32", SampleType::f32},
                                                          {"f64", SampleType::f64},
                                                          {"i64", SampleType::i64},
                                                          {"u64", SampleType::u64},
                                                          // MetaImage's
                                                          {"MET_UCHAR", SampleType::u8},
                                                          {"MET_CHAR", SampleType::i8},
                                                          {"MET_USHORT", SampleType::u16},
                                                          {"MET_SHORT", SampleType::i16},
                                                          {"MET_UINT", SampleType::u32},
                                                          {"MET_INT", SampleType::i32},
                                                          {"MET_FLOAT", SampleType::f32},
                                                          {"MET_DOUBLE", SampleType::f64},
                                                          {"MET_LONG_LONG", SampleType::i64},
                                                          {"MET_ULONG_LONG", SampleType::u64},
                                                          // NRRD's
                                                          {"uchar", SampleType::u8},
                                                          {"unsigned char", SampleType::u8},
                                                          {"uint8", SampleType::u8},
                                                          {"uint8_t", SampleType::u8},
                                                          {"signed char", SampleType::i8},
                                                          {"int8", SampleType::i8},
                                                          {"int8_t", SampleType::i8},
                                                          {"ushort", SampleType::u16},
                                                          {"unsigned short", SampleType::u16},
                                                          {"unsigned short int", SampleType::u16},
                                                          {"uint16", SampleType::u16},
                                                          {"uint16_t", SampleType::u16},
                                                          {"short", SampleType::i16},
                                                          {"short int", SampleType::i16},
                                                          {"signed short", SampleType::i16},
                                                          {"signed short int", SampleType::i16},
                                                          {"int16", SampleType::i16},
                                                          {"int16_t", SampleType::i16},
                                                          {"uint", SampleType::u32},
                                                          {"unsigned int", SampleType::u32},
                                                          {"uint32", SampleType::u32},
                                                          {"uint32_t", SampleType::u32},
                                                          {"int", SampleType::i32},
                                                          {"signed int", SampleType::i32},
                                                          {"int32", SampleType::i32},
                                                          {"int32_t", SampleType::i32},
                                                          {"longlong", SampleType::i64},
                                                          {"long long", SampleType::i64},
                                                          {"long long int", SampleType::i64},
                                                          {"signed long long", SampleType::i64},
                                                          {"signed long long int", SampleType::i64},
                                                          {"int64", SampleType::i64},
                                                          {"int64_t", SampleType::i64},
                                                          {"ulonglong", SampleType::u64},
                                                          {"unsigned long long", SampleType::u64},
                                                          {"unsigned long long int", SampleType::u64},
                                                          {"uint64", SampleType::u64},
                                                          {"uint64_t", SampleType::u64},
                                                          {"float", SampleType::f32},
                                                          {"double", SampleType::f64}};
  const auto found = names.find(name);
  return found == names.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace isobench
