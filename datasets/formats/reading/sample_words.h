// Samples that are written as text.
#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <vector>

#include "isobench/datasets/formats/reading/byte_reader.h"

namespace isobench {

inline constexpr std::size_t longest_number = 400;  // characters; printf's %f of the largest double takes 317

inline bool is_blank(char c) { return c == ' ' || c == '\t' || c == ',' || c == '\r' || c == '\n'; }

/// The number that a word states; std::nullopt for other words. An integer may be written as 3, 3.0 or 3e0. A
/// floating-point number too large for its type becomes infinite, which is refused later with its node; one too small
/// becomes 0.
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
  std::optional<std::string_view> next();

 private:
  bool take(char& c);

  ByteReader& reader_;
  std::vector<char> block_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::string word_;
};

}  // namespace isobench
