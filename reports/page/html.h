// Text and tables as HTML.
#pragma once

#include <string>
#include <string_view>

#include "isobench/reports/tables/table.h"

namespace isobench {

/// Text with the characters that HTML reserves replaced.
std::string html_escaped(std::string_view text);
/// The same; words between backticks become <code>.
std::string html_prose(std::string_view text);
/// Bytes in base 64.
std::string base64(const std::string& bytes);
/// "data:image/png;base64,…": an address that holds the content of a file.
std::string data_uri(const std::string& media_type, const std::string& bytes);

/// A table with its title, remarks and folded definitions. A very long table is folded, too. A cell with figures
/// carries the number that it is sorted by. A table with empty first cells cannot be sorted, because such a row belongs
/// to the one above it.
std::string html(const Table& table);

}  // namespace isobench
