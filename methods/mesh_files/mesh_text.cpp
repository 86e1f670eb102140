#include "isobench/methods/mesh_files/mesh_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

template <typename Number>
std::optional<Number> parse(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);  // from_chars does not accept a plus sign
  Number value{};
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || stop != word.data() + word.size()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> to_number(std::string_view word) { return parse<double>(word); }
std::optional<long> to_integer(std::string_view word) { return parse<long>(word); }

TextLines::TextLines(std::string_view text, std::filesystem::path path, Continued continued)
    : text_(text), path_(std::move(path)), continued_(continued) {
  if (text_.starts_with(utf8_mark)) text_.remove_prefix(utf8_mark.size());
}

std::string_view TextLines::take_line() {
  const std::size_t end = std::min(text_.find_first_of("\r\n"), text_.size());
  const std::string_view line = text_.substr(0, end);
  text_.remove_prefix(end);
  text_.remove_prefix(text_.starts_with("\r\n") ? 2 : std::min<std::size_t>(text_.size(), 1));
  ++line_;
  return line;
}

bool TextLines::next() {
  constexpr std::string_view kBlanks = " \t\v\f";
  words_.clear();
  for (bool goes_on = false; (words_.empty() || goes_on) && !text_.empty();) {
    std::string_view line = take_line();
    goes_on = continued_ == Continued::after_backslash && line.ends_with('\\');
    if (goes_on) line.remove_suffix(1);
    line = line.substr(0, line.find('#'));
    for (std::size_t from = line.find_first_not_of(kBlanks); from != std::string_view::npos;) {
      const std::size_t to = std::min(line.find_first_of(kBlanks, from), line.size());
      words_.push_back(line.substr(from, to - from));
      from = line.find_first_not_of(kBlanks, to);
    }
  }
  return !words_.empty();
}

void TextLines::fail(const std::string& message) const {
  throw DataError(fmt::format("{}:{}: {}", path_.string(), line_, message));
}

double TextLines::number(std::size_t n) const {
  const std::optional<double> value = n < words_.size() ? to_number(words_[n]) : std::nullopt;
  if (!value) fail(n < words_.size() ? fmt::format("'{}' is not a number", words_[n]) : "a number is missing");
  return *value;
}

long TextLines::integer(std::size_t n) const {
  const std::optional<long> value = n < words_.size() ? to_integer(words_[n]) : std::nullopt;
  if (!value) fail(n < words_.size() ? fmt::format("'{}' is not an integer", words_[n]) : "an integer is missing");
  return *value;
}

Eigen::Vector3d TextLines::position(std::size_t n) const {
  if (words_.size() < n + 3 && words_.size() > n) {
    fail(fmt::format("a point has {} coordinates; three are needed", words_.size() - n));
  }
  return {number(n), number(n + 1), number(n + 2)};
}

std::uint32_t to_index(double value) {
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  return value >= 0.0 && value < none && value == std::floor(value) ? static_cast<std::uint32_t>(value) : none;
}

}  // namespace isobench
