// Text mesh formats line by line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isobench {

/// The words of one line after another; comments (from '#') and empty lines are passed over.
class TextLines {
 public:
  TextLines(std::string_view text, std::filesystem::path path) : text_(text), path_(std::move(path)) {}
  /// False at the end.
  bool next();
  const std::vector<std::string_view>& words() const { return words_; }
  /// DataError: "path:line: message".
  [[noreturn]] void fail(const std::string& message) const;
  /// Word n as a number or an integer; fail() if the line has none there.
  double number(std::size_t n) const;
  long integer(std::size_t n) const;

 private:
  std::string_view text_;
  std::filesystem::path path_;
  std::vector<std::string_view> words_;
  std::size_t line_ = 0;
};

std::optional<double> to_number(std::string_view word);
std::optional<long> to_integer(std::string_view word);
/// What is no index becomes one that no mesh has, for read_mesh() to report.
std::uint32_t to_index(double value);

}  // namespace isobench
