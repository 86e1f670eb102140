// A Markdown table that is also readable as plain text.
#pragma once

#include <string>
#include <vector>

namespace isobench {

class MarkdownTable {
 public:
  explicit MarkdownTable(std::vector<std::string> header) : header_(std::move(header)) {}
  /// As many cells as the header has; '|' is escaped.
  void add(std::vector<std::string> row);
  bool empty() const { return rows_.empty(); }
  /// Columns padded to equal width (in characters, not bytes).
  std::string text() const;

 private:
  std::vector<std::string> header_;
  std::vector<std::vector<std::string>> rows_;
};

/// `value` with so many significant digits: 0.0195 for (0.01953, 3), 7.07e-06 below 0.0001. "–" where it is not finite.
std::string significant(double value, int digits);

}  // namespace isobench
