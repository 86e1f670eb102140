#include "isobench/datasets/formats/sample_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

constexpr std::size_t chunk_bytes = std::size_t{1} << 20U;

bool is_foreign(ByteOrder order) { return (order == ByteOrder::big) != (std::endian::native == std::endian::big); }

bool is_blank(char c) { return c == ' ' || c == '\t' || c == ',' || c == '\r' || c == '\n'; }

constexpr std::size_t longest_number = 400;  // characters; printf's %f of the largest double takes 317

/// Converts the samples from number `first` on from the file's byte order to this machine's.
template <class T>
void to_native_order(std::vector<T>& samples, std::size_t first, ByteOrder order) {
  if (sizeof(T) == 1 || !is_foreign(order)) return;
  for (std::size_t n = first; n < samples.size(); ++n) {
    auto raw = std::bit_cast<std::array<char, sizeof(T)>>(samples[n]);
    std::reverse(raw.begin(), raw.end());
    samples[n] = std::bit_cast<T>(raw);
  }
}

/// The number that a word states; std::nullopt for other words. A floating-point number too large for its type becomes
/// infinite, and check_finite() refuses it later and names its node; one too small becomes 0.
template <class T>
std::optional<T> number_of_word(std::string_view word) {
  if (word.size() > longest_number) return std::nullopt;
  T value{};
  const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc() && rest == word.data() + word.size()) return value;
  if constexpr (std::is_integral_v<T>) {
    const std::optional<double> real = number_of_word<double>(word);
    const auto least = static_cast<double>(std::numeric_limits<T>::min());
    const double beyond = std::ldexp(1.0, std::numeric_limits<T>::digits);  // one more than the largest T
    if (real && *real == std::floor(*real) && *real >= least && *real < beyond) return static_cast<T>(*real);
  } else if (error == std::errc::result_out_of_range && rest == word.data() + word.size()) {
    return static_cast<T>(std::strtod(std::string(word).c_str(), nullptr));
  }
  return std::nullopt;
}

/// Words between blanks or commas. They are read in blocks, because a text need not have lines.
class Words {
 public:
  explicit Words(ByteReader& reader) : reader_(reader), block_(std::size_t{1} << 16U) {}

  /// std::nullopt at the end of the text.
  std::optional<std::string_view> next() {
    char c = ' ';
    while (is_blank(c)) {
      if (!take(c)) return std::nullopt;
    }
    word_.clear();
    do {
      word_.push_back(c);
      if (word_.size() > longest_number) return word_;
    } while (take(c) && !is_blank(c));
    return word_;
  }

 private:
  bool take(char& c) {
    if (begin_ == end_) {
      begin_ = 0;
      end_ = reader_.read(block_.data(), block_.size());
      if (end_ == 0) return false;
    }
    c = block_[begin_++];
    return true;
  }

  ByteReader& reader_;
  std::vector<char> block_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::string word_;
};

[[noreturn]] void throw_truncated(const std::filesystem::path& path, std::size_t found, std::size_t expected) {
  throw DataError(fmt::format(
      "{}: truncated: its header states {} samples, but data for at most {} follow; copy or export it again",
      path.string(), expected, found));
}

template <class T>
void read_binary(ByteReader& reader, std::size_t count, ByteOrder order, std::vector<T>& samples) {
  const std::size_t possible = reader.possible_bytes() / sizeof(T);
  if (possible < count) throw_truncated(reader.path(), possible, count);
  // This takes only addresses, no memory yet: a compressed file's header may state a thousand times what it holds.
  samples.reserve(samples.size() + count);
  for (std::size_t done = 0; done < count;) {
    const std::size_t part = std::min(count - done, chunk_bytes / sizeof(T));
    const std::size_t first = samples.size();
    samples.resize(first + part);
    const std::size_t got = reader.read(reinterpret_cast<char*>(samples.data() + first), part * sizeof(T)) / sizeof(T);
    if (got < part) throw_truncated(reader.path(), done + got, count);
    to_native_order(samples, first, order);
    done += part;
  }
  reader.finish();
}

template <class T>
SampleType type_of_samples() {
  return Samples(std::vector<T>()).type();
}

template <class T>
void read_text(ByteReader& reader, std::size_t count, std::vector<T>& samples) {
  const std::size_t possible = reader.possible_bytes() / 2 + 1;  // a digit and a blank each
  if (possible < count) throw_truncated(reader.path(), possible, count);
  samples.reserve(samples.size() + count);
  Words words(reader);
  for (std::size_t done = 0; done < count; ++done) {
    const std::optional<std::string_view> word = words.next();
    if (!word) throw_truncated(reader.path(), done, count);
    const std::optional<T> value = number_of_word<T>(*word);
    if (!value) {
      throw DataError(fmt::format("{}: '{}' among its samples is not a number of type {}; export it again",
                                  reader.path().string(), word->substr(0, 20), to_string(type_of_samples<T>())));
    }
    samples.push_back(*value);
  }
  reader.finish();
}

}  // namespace

void convert_samples(const char* bytes, std::size_t count, SampleType type, ByteOrder order, double* numbers) {
  Samples(type).visit([&](const auto& none) {
    using T = SampleOf<decltype(none)>;
    for (std::size_t n = 0; n < count; ++n) {
      std::array<char, sizeof(T)> raw{};
      std::memcpy(raw.data(), bytes + n * sizeof(T), sizeof(T));
      if (is_foreign(order)) std::reverse(raw.begin(), raw.end());
      numbers[n] = static_cast<double>(std::bit_cast<T>(raw));
    }
  });
}

Samples samples_of_bytes(const char* bytes, std::size_t count, SampleType type, ByteOrder order) {
  Samples samples(type);
  samples.visit([&](auto& values) {
    values.resize(count);
    std::memcpy(values.data(), bytes, count * bytes_of(type));
    to_native_order(values, 0, order);
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

void read_samples(ByteReader& reader, std::size_t count, ByteOrder order, Samples& samples) {
  samples.visit([&](auto& values) { read_binary(reader, count, order, values); });
}

void read_text_samples(ByteReader& reader, std::size_t count, Samples& samples) {
  samples.visit([&](auto& values) { read_text(reader, count, values); });
}

}  // namespace isobench
