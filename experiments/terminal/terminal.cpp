#include "isobench/experiments/terminal/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <sstream>
#include <string_view>

namespace isobench {

namespace {

// Narrower than this, a text is a column of single words.
constexpr std::size_t least_width = 20;

bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

std::optional<std::size_t> columns_of_environment() {
  const char* const variable = std::getenv("COLUMNS");
  const std::string_view text = variable == nullptr ? "" : variable;
  std::size_t columns = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), columns);
  if (error != std::errc() || end != text.data() + text.size() || columns < least_width) return std::nullopt;
  return columns;
}

// The widest cell of every column but the last one of each row.
std::vector<std::size_t> column_widths(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const std::vector<std::string>& row : rows) {
    if (row.size() > widths.size() + 1) widths.resize(row.size() - 1);
    for (std::size_t n = 0; n + 1 < row.size(); ++n) widths[n] = std::max(widths[n], character_count(row[n]));
  }
  return widths;
}

}  // namespace

std::optional<std::size_t> terminal_width(int descriptor) {
  if (isatty(descriptor) != 1) return std::nullopt;
  constexpr std::size_t usual = 100;
  winsize size{};
  return ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col >= least_width ? size.ws_col : usual;
}

std::size_t output_width() {
  if (const auto columns = columns_of_environment()) return *columns;
  return terminal_width(STDOUT_FILENO).value_or(unlimited_width);
}

std::size_t character_count(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_character));
}

std::string first_characters(const std::string& text, std::size_t count) {
  std::size_t end = 0;
  for (std::size_t seen = 0; end < text.size(); ++end) {
    if (begins_character(text[end]) && ++seen > count) break;
  }
  return text.substr(0, end);
}

std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
  std::string result;
  std::size_t column = indent;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::size_t length = character_count(word);
    if (!result.empty()) {
      const bool fits = column + 1 + length <= width;
      result += fits ? " " : "\n" + std::string(indent, ' ');
      column = fits ? column + 1 : indent;
    }
    result += word;
    column += length;
  }
  return result;
}

std::string aligned_rows(const std::vector<std::vector<std::string>>& rows, std::size_t width) {
  const std::vector<std::size_t> widths = column_widths(rows);
  std::size_t text_start = 0;
  for (const std::size_t columns : widths) text_start += columns + 2;
  constexpr std::size_t least_text = 30;
  const bool below = text_start + least_text > width;
  std::string result;
  for (const std::vector<std::string>& row : rows) {
    std::string line;
    for (std::size_t n = 0; n + 1 < row.size(); ++n) {
      const std::size_t padding = below ? 0 : widths[n] - character_count(row[n]);
      line += row[n] + std::string(padding + 2, ' ');
    }
    const std::size_t indent =
        below ? std::min(row.front().find_first_not_of(' '), row.front().size()) + 4 : text_start;
    if (below) line += "\n" + std::string(indent, ' ');
    line += wrapped(row.back(), indent, width);
    // No line ends with spaces, even if its last cell is empty or stands below it.
    for (std::size_t at = line.find(" \n"); at != std::string::npos; at = line.find(" \n")) line.erase(at, 1);
    line.erase(line.find_last_not_of(" \n") + 1);
    result += line + "\n";
  }
  return result;
}

}  // namespace isobench
