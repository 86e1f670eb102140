// Text for an HTML page.
#pragma once

#include <string>
#include <string_view>

#include "isobench/reports/tables/table.h"

namespace isobench {

/// Text as HTML shows it.
std::string html_escaped(std::string_view text);
/// The same, with `words between backticks` as code.
std::string html_prose(std::string_view text);
/// Bytes as letters, digits, + and /.
std::string base64(const std::string& bytes);
/// "data:image/png;base64,…": a file's content in the place of its address.
std::string data_uri(const std::string& media_type, const std::string& bytes);

/// A table with its title, and what belongs under it behind a fold, as a table is itself that is very long. Every cell
/// carries the number that it sorts by; a table whose rows lean on the one above them (an empty first cell) is not
/// marked as one that can be sorted.
std::string html(const Table& table);

}  // namespace isobench
