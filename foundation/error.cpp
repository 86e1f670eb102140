#include "isobench/foundation/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <string_view>

namespace isobench {

std::string to_string(const Place& place) {
  if (place.file.empty()) return "";
  std::string text = place.file + ":";
  if (place.line > 0) text += std::to_string(place.line) + ":";
  if (place.line > 0 && place.column > 0) text += std::to_string(place.column) + ":";
  return text + " ";
}

namespace {

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// The number of bytes of the UTF-8 character at the beginning of a text; 0 for a control character or invalid bytes.
std::size_t character_length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80U) return lead < 0x20U || lead == 0x7FU ? 0 : 1;
  const std::size_t length = lead >= 0xC2U && lead < 0xE0U   ? 2
                             : lead >= 0xE0U && lead < 0xF0U ? 3
                             : lead >= 0xF0U && lead < 0xF5U ? 4
                                                             : 0;
  if (length == 0 || text.size() < length || !std::all_of(text.begin() + 1, text.begin() + length, continues)) return 0;
  // In this order: control characters U+0080 to U+009F, overlong forms, surrogates, overlong forms, beyond Unicode.
  const auto second = static_cast<unsigned char>(text[1]);
  const bool forbidden = (lead == 0xC2U && second < 0xA0U) || (lead == 0xE0U && second < 0xA0U) ||
                         (lead == 0xEDU && second >= 0xA0U) || (lead == 0xF0U && second < 0x90U) ||
                         (lead == 0xF4U && second >= 0x90U);
  return forbidden ? 0 : length;
}

std::string escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0) result += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
    result += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

}  // namespace

std::string printable(const std::string& text) {
  constexpr std::size_t limit = 1000;
  if (text.size() <= limit) return escaped(text);
  const std::string_view whole = text;
  return escaped(whole.substr(0, limit / 2)) + " … " + escaped(whole.substr(whole.size() - limit / 2));
}

namespace {

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitution = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitution});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates) {
  std::string best;
  // If more than a third of the letters differ (and more than two), it is another word, not a misspelling.
  std::size_t best_distance = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const bool extends = name.size() >= 3 && candidate.starts_with(name);
    const std::size_t distance = extends ? 1 : edit_distance(name, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string suggestion(const std::string& name, const std::vector<std::string>& candidates) {
  const std::string nearest = nearest_name(name, candidates);
  if (!nearest.empty()) return "; did you mean '" + nearest + "'?";
  std::string known = "; known are: ";
  for (std::size_t i = 0; i < candidates.size(); ++i) known += (i > 0 ? ", " : "") + candidates[i];
  return known;
}

}  // namespace isobench
