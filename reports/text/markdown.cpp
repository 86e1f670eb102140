#include "isobench/reports/text/markdown.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace isobench {

namespace {

// Number of characters of UTF-8 text: all bytes except continuation bytes.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '|') result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result;
}

std::string line(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) {
  std::string text = "|";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    text += " " + cells[i] + std::string(widths[i] - width(cells[i]), ' ') + " |";
  }
  return text + "\n";
}

}  // namespace

void MarkdownTable::add(std::vector<std::string> row) {
  if (row.size() != header_.size()) throw std::logic_error("a table row must have as many cells as the header");
  for (std::string& cell : row) cell = escaped(cell);
  rows_.push_back(std::move(row));
}

std::string MarkdownTable::text() const {
  std::vector<std::size_t> widths(header_.size(), 3);
  for (std::size_t i = 0; i < header_.size(); ++i) {
    widths[i] = std::max(widths[i], width(header_[i]));
    for (const auto& row : rows_) widths[i] = std::max(widths[i], width(row[i]));
  }
  std::vector<std::string> rule;
  for (const std::size_t columns : widths) rule.emplace_back(columns, '-');
  std::string text = line(header_, widths) + line(rule, widths);
  for (const auto& row : rows_) text += line(row, widths);
  return text;
}

std::string significant(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  if (value == 0.0) return "0";
  if (std::abs(value) < 1e-4) return fmt::format("{:.{}e}", value, digits - 1);
  const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
  return fmt::format("{:.{}f}", value, std::max(0, digits - 1 - magnitude));
}

}  // namespace isobench
