// How wide the terminal is, and text laid out for that width. Widths count characters, not bytes.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace isobench {

/// A width at which no line is ever wrapped.
constexpr std::size_t unlimited_width = std::numeric_limits<std::size_t>::max();

/// Columns of the terminal that a file descriptor is connected to; 100 if the terminal states none or fewer than 20.
/// std::nullopt if the descriptor is a file or a pipe.
std::optional<std::size_t> terminal_width(int descriptor);

/// How wide text on stdout may be: the environment variable COLUMNS where it is a whole number of at least 20,
/// otherwise the terminal's width. In a file or a pipe nothing is wrapped: an entry that `grep` finds is then complete.
std::size_t output_width();

/// The number of characters in a UTF-8 text.
std::size_t character_count(const std::string& text);
/// The first `count` characters of a UTF-8 text, or all of it.
std::string first_characters(const std::string& text, std::size_t count);

/// Breaks a text at spaces so that lines that begin in column `indent` end before column `width`. The first line is
/// not indented, because it follows other text. A word that is too long for a line is not broken. No line break at the
/// end.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width);

/// Rows of cells, in columns that are two spaces apart; each row ends with a line break. The last cell of a row is
/// wrapped within its column. Where `width` leaves fewer than 30 characters for it, it is wrapped below the others.
std::string aligned_rows(const std::vector<std::vector<std::string>>& rows, std::size_t width);

}  // namespace isobench
