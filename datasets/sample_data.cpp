#include "datasets/sample_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <limits>
#include <map>

#include "datasets/error.h"

namespace isobench {

namespace {

constexpr std::size_t chunk_bytes = std::size_t{1} << 20U;

template <typename Sample>
void convert(const char* bytes, std::size_t count, bool swap, float* samples) {
  for (std::size_t n = 0; n < count; ++n) {
    std::array<char, sizeof(Sample)> raw{};
    std::memcpy(raw.data(), bytes + n * sizeof(Sample), sizeof(Sample));
    if (swap) std::reverse(raw.begin(), raw.end());
    samples[n] = static_cast<float>(std::bit_cast<Sample>(raw));
  }
}

void convert(const char* bytes, std::size_t count, SampleType type, bool swap, float* samples) {
  switch (type) {
    case SampleType::u8:
      return convert<std::uint8_t>(bytes, count, swap, samples);
    case SampleType::i8:
      return convert<std::int8_t>(bytes, count, swap, samples);
    case SampleType::u16:
      return convert<std::uint16_t>(bytes, count, swap, samples);
    case SampleType::i16:
      return convert<std::int16_t>(bytes, count, swap, samples);
    case SampleType::u32:
      return convert<std::uint32_t>(bytes, count, swap, samples);
    case SampleType::i32:
      return convert<std::int32_t>(bytes, count, swap, samples);
    case SampleType::f32:
      return convert<float>(bytes, count, swap, samples);
    case SampleType::f64:
      return convert<double>(bytes, count, swap, samples);
  }
}

[[noreturn]] void throw_truncated(const std::filesystem::path& path, std::size_t found, std::size_t expected) {
  throw DataError(fmt::format(
      "{}: truncated: its header promises {} samples but data for at most {} follow; copy or export it again",
      path.string(), expected, found));
}

}  // namespace

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
      return 8;
  }
  return 1;
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
                                                          // MetaImage's
                                                          {"MET_UCHAR", SampleType::u8},
                                                          {"MET_CHAR", SampleType::i8},
                                                          {"MET_USHORT", SampleType::u16},
                                                          {"MET_SHORT", SampleType::i16},
                                                          {"MET_UINT", SampleType::u32},
                                                          {"MET_INT", SampleType::i32},
                                                          {"MET_FLOAT", SampleType::f32},
                                                          {"MET_DOUBLE", SampleType::f64},
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
                                                          {"float", SampleType::f32},
                                                          {"double", SampleType::f64}};
  const auto found = names.find(name);
  return found == names.end() ? std::nullopt : std::optional(found->second);
}

void read_samples(ByteReader& reader, std::size_t count, SampleType type, ByteOrder order,
                  std::vector<float>& samples) {
  const std::size_t bytes = bytes_of(type);
  const std::size_t possible = reader.possible_bytes() / bytes;
  if (possible < count) throw_truncated(reader.path(), possible, count);
  const bool swap = (order == ByteOrder::big) != (std::endian::native == std::endian::big);
  const std::size_t first = samples.size();
  samples.resize(first + count);
  std::vector<char> chunk(std::min(count * bytes, chunk_bytes));
  for (std::size_t done = 0; done < count;) {
    const std::size_t part = std::min(count - done, chunk.size() / bytes);
    const std::size_t got = reader.read(chunk.data(), part * bytes) / bytes;
    if (got < part) throw_truncated(reader.path(), done + got, count);
    convert(chunk.data(), part, type, swap, samples.data() + first + done);
    done += part;
  }
  if (reader.encoding() == Encoding::deflated) reader.drain();
}

void read_text_samples(ByteReader& reader, std::size_t count, std::vector<float>& samples) {
  const std::size_t possible = reader.possible_bytes() / 2 + 1;  // a digit and a blank each
  if (possible < count) throw_truncated(reader.path(), possible, count);
  samples.reserve(samples.size() + count);
  const std::size_t end = samples.size() + count;
  std::string line;
  while (samples.size() < end && reader.read_line(line, std::numeric_limits<std::size_t>::max())) {
    const char* next = line.data();
    const char* const stop = line.data() + line.size();
    while (samples.size() < end) {
      next = std::find_if(next, stop, [](char c) { return c != ' ' && c != '\t' && c != ','; });
      if (next == stop) break;
      float value = 0.0F;
      const auto [rest, error] = std::from_chars(next, stop, value);
      if (error != std::errc()) {
        throw DataError(fmt::format("{}: '{}' among its samples is not a number; export it again",
                                    reader.path().string(),
                                    std::string(next, std::min<std::ptrdiff_t>(stop - next, 20))));
      }
      samples.push_back(value);
      next = rest;
    }
  }
  if (reader.encoding() == Encoding::deflated) reader.drain();
  if (samples.size() < end) throw_truncated(reader.path(), count - (end - samples.size()), count);
}

}  // namespace isobench
