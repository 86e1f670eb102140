// For tests: counts parts of a text, and splits it into lines and cells.
#pragma once

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace isobench {

/// How often `part` occurs in `text`.
inline std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

inline std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

/// The cells of a line of CSV (RFC 4180).
inline std::vector<std::string> csv_cells(const std::string& line) {
  std::vector<std::string> result(1);
  bool inside = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && inside && i + 1 < line.size() && line[i + 1] == '"')
      result.back() += line[i++];
    else if (line[i] == '"')
      inside = !inside;
    else if (line[i] == ',' && !inside)
      result.emplace_back();
    else
      result.back() += line[i];
  }
  return result;
}

}  // namespace isobench
