// Reads text formats of meshes line by line.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isobench {

/// The byte order mark that some programs put before UTF-8 text.
inline constexpr std::string_view utf8_mark = "\xef\xbb\xbf";

/// Whether a line that ends in a backslash goes on in the next one.
enum class Continued { never, after_backslash };

/// Gives the words of one line after another, without empty lines and comments (from '#' on). Lines end as in Unix,
/// Windows or old Macs; a byte order mark of UTF-8 is skipped.
class TextLines {
 public:
  TextLines(std::string_view text, std::filesystem::path path, Continued continued = Continued::never);
  /// Moves to the next line; false at the end of the text.
  bool next();
  const std::vector<std::string_view>& words() const { return words_; }
  /// The text behind the current line.
  std::string_view rest() const { return text_; }
  /// Throws DataError("path:line: message").
  [[noreturn]] void fail(const std::string& message) const;
  /// Word n as a number or an integer; calls fail() if there is none.
  double number(std::size_t n) const;
  long integer(std::size_t n) const;
  /// The first three words from word n on as a position; calls fail() if there are not three numbers.
  Eigen::Vector3d position(std::size_t n) const;

 private:
  std::string_view take_line();

  std::string_view text_;
  std::filesystem::path path_;
  std::vector<std::string_view> words_;
  Continued continued_;
  std::size_t line_ = 0;
};

std::optional<double> to_number(std::string_view word);
std::optional<long> to_integer(std::string_view word);
/// The value as an index. A value that is not an index becomes one that no mesh has, and read_mesh() reports it.
std::uint32_t to_index(double value);

}  // namespace isobench
