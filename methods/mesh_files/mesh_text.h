// Reads text formats of meshes line by line.
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

/// Gives the words of one line after another, without empty lines and comments (from '#' on).
class TextLines {
 public:
  TextLines(std::string_view text, std::filesystem::path path) : text_(text), path_(std::move(path)) {}
  /// Moves to the next line; false at the end of the text.
  bool next();
  const std::vector<std::string_view>& words() const { return words_; }
  /// Throws DataError("path:line: message").
  [[noreturn]] void fail(const std::string& message) const;
  /// Word n as a number or an integer; calls fail() if there is none.
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
/// The value as an index. A value that is not an index becomes one that no mesh has, and read_mesh() reports it.
std::uint32_t to_index(double value);

}  // namespace isobench
