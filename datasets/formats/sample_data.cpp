#include "isobench/datasets/formats/sample_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <map>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

constexpr std::size_t conversion_bytes = std::size_t{1} << 20U;

template <typename Sample, typename Number>
void convert(const char* bytes, std::size_t count, bool swap, Number* numbers) {
  for (std::size_t n = 0; n < count; ++n) {
    std::array<char, sizeof(Sample)> raw{};
    std::memcpy(raw.data(), bytes + n * sizeof(Sample), sizeof(Sample));
    if (swap) std::reverse(raw.begin(), raw.end());
    numbers[n] = static_cast<Number>(std::bit_cast<Sample>(raw));
  }
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == ',' || c == '\r' || c == '\n'; }

/// Numbers between blanks or commas, read in blocks: a text need not have lines.
class TextNumbers {
 public:
  explicit TextNumbers(ByteReader& reader) : reader_(reader), block_(std::size_t{1} << 16U) {}

  /// std::nullopt where the text ends.
  std::optional<float> next() {
    char c = ' ';
    while (is_blank(c)) {
      if (!take(c)) return std::nullopt;
    }
    std::string word;
    do {
      word.push_back(c);
      if (word.size() > longest) fail(word);
    } while (take(c) && !is_blank(c));
    float value = 0.0F;
    const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || rest != word.data() + word.size()) fail(word);
    return value;
  }

 private:
  static constexpr std::size_t longest = 400;  // printf's %f of the largest double takes 317

  bool take(char& c) {
    if (begin_ == end_) {
      begin_ = 0;
      end_ = reader_.read(block_.data(), block_.size());
      if (end_ == 0) return false;
    }
    c = block_[begin_++];
    return true;
  }
  [[noreturn]] void fail(const std::string& word) const {
    throw DataError(fmt::format("{}: '{}' among its samples is not a number; export it again", reader_.path().string(),
                                word.substr(0, 20)));
  }

  ByteReader& reader_;
  std::vector<char> block_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
};

[[noreturn]] void throw_truncated(const std::filesystem::path& path, std::size_t found, std::size_t expected) {
  throw DataError(fmt::format(
      "{}: truncated: its header promises {} samples but data for at most {} follow; copy or export it again",
      path.string(), expected, found));
}

}  // namespace

template <class Number>
void convert_samples(const char* bytes, std::size_t count, SampleType type, ByteOrder order, Number* numbers) {
  const bool swap = (order == ByteOrder::big) != (std::endian::native == std::endian::big);
  switch (type) {
    case SampleType::u8:
      return convert<std::uint8_t>(bytes, count, swap, numbers);
    case SampleType::i8:
      return convert<std::int8_t>(bytes, count, swap, numbers);
    case SampleType::u16:
      return convert<std::uint16_t>(bytes, count, swap, numbers);
    case SampleType::i16:
      return convert<std::int16_t>(bytes, count, swap, numbers);
    case SampleType::u32:
      return convert<std::uint32_t>(bytes, count, swap, numbers);
    case SampleType::i32:
      return convert<std::int32_t>(bytes, count, swap, numbers);
    case SampleType::f32:
      return convert<float>(bytes, count, swap, numbers);
    case SampleType::f64:
      return convert<double>(bytes, count, swap, numbers);
    case SampleType::i64:
      return convert<std::int64_t>(bytes, count, swap, numbers);
    case SampleType::u64:
      return convert<std::uint64_t>(bytes, count, swap, numbers);
  }
}
template void convert_samples(const char*, std::size_t, SampleType, ByteOrder, float*);
template void convert_samples(const char*, std::size_t, SampleType, ByteOrder, double*);

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
                                                          {"int64", SampleType::i64},
                                                          {"int64_t", SampleType::i64},
                                                          {"ulonglong", SampleType::u64},
                                                          {"unsigned long long", SampleType::u64},
                                                          {"uint64", SampleType::u64},
                                                          {"uint64_t", SampleType::u64},
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
  // Reserving takes no memory yet: a compressed file may promise a thousand times what it holds.
  samples.reserve(samples.size() + count);
  std::vector<char> chunk(std::min(count * bytes, conversion_bytes));
  for (std::size_t done = 0; done < count;) {
    const std::size_t part = std::min(count - done, chunk.size() / bytes);
    const std::size_t got = reader.read(chunk.data(), part * bytes) / bytes;
    if (got < part) throw_truncated(reader.path(), done + got, count);
    samples.resize(samples.size() + part);
    convert_samples(chunk.data(), part, type, order, samples.data() + samples.size() - part);
    done += part;
  }
  reader.finish();
}

void read_text_samples(ByteReader& reader, std::size_t count, std::vector<float>& samples) {
  const std::size_t possible = reader.possible_bytes() / 2 + 1;  // a digit and a blank each
  if (possible < count) throw_truncated(reader.path(), possible, count);
  samples.reserve(samples.size() + count);
  TextNumbers numbers(reader);
  for (std::size_t done = 0; done < count; ++done) {
    const std::optional<float> value = numbers.next();
    if (!value) throw_truncated(reader.path(), done, count);
    samples.push_back(*value);
  }
  reader.finish();
}

}  // namespace isobench
