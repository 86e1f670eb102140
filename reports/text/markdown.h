// Markdown tables that can also be read as plain text, and rounded numbers.
#pragma once

#include <string>
#include <vector>

namespace isobench {

class MarkdownTable {
 public:
  explicit MarkdownTable(std::vector<std::string> header) : header_(std::move(header)) {}
  /// Adds a row, which must have as many cells as the header. '|' in a cell is escaped.
  void add(std::vector<std::string> row);
  bool empty() const { return rows_.empty(); }
  /// The table, with columns of equal width in characters (not bytes).
  std::string text() const;

 private:
  std::vector<std::string> header_;
  std::vector<std::vector<std::string>> rows_;
};

/// `value` with this many significant digits: 0.0195 for (0.01953, 3); 7.07e-06 for values below 0.0001. "–" if it is
/// not finite.
std::string significant(double value, int digits);

}  // namespace isobench
