#include "isobench/methods/external/command_line.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "isobench/foundation/error.h"
#include "isobench/methods/mesh_files/mesh_text.h"

namespace isobench::external {

namespace {

constexpr const char* blanks = " \t\r\n";

// The word that begins at `at`; sets `at` behind its end.
std::string next_word(const std::string& text, std::size_t& at) {
  std::string word;
  char quote = 0;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (quote == 0 && std::string(blanks).find(c) != std::string::npos) break;
    if (c == '\\' && quote != '\'' && at + 1 < text.size()) {
      // Between double quotes a backslash stands for itself unless a quote or a backslash follows.
      const char next = text[at + 1];
      if (quote == '"' && next != '"' && next != '\\') word += c;
      word += next;
      ++at;
    } else if (quote == 0 && (c == '\'' || c == '"')) {
      quote = c;
    } else if (c == quote) {
      quote = 0;
    } else {
      word += c;
    }
  }
  if (quote != 0) throw UsageError(fmt::format("the quote {} is not closed in: {}", quote, text));
  return word;
}

struct Placeholder {
  std::string name;
  double factor = 1.0;
  bool scaled = false;
};

Placeholder parse(const std::string& inner) {
  Placeholder found{inner};
  const std::size_t sign = inner.find_first_of("*/");
  if (sign == std::string::npos) return found;
  const std::optional<double> number = to_number(std::string_view(inner).substr(sign + 1));
  if (!number || !std::isfinite(*number) || *number <= 0.0) {
    throw UsageError(fmt::format("{{{}}} must multiply or divide by a number > 0", inner));
  }
  found.name.resize(sign);
  found.factor = inner[sign] == '*' ? *number : 1.0 / *number;
  found.scaled = true;
  return found;
}

// The word with each placeholder replaced by the result of `replace`.
std::string replaced(const std::string& word, const std::function<std::string(const Placeholder&)>& replace) {
  std::string result;
  for (std::size_t at = 0; at < word.size(); ++at) {
    const char c = word[at];
    const bool doubled = at + 1 < word.size() && word[at + 1] == c;
    if ((c == '{' || c == '}') && doubled) {
      result += c;
      ++at;
    } else if (c == '{') {
      const std::size_t end = word.find('}', at);
      if (end == std::string::npos) throw UsageError("a { is not closed in " + word + "; a brace itself is written {{");
      result += replace(parse(word.substr(at + 1, end - at - 1)));
      at = end;
    } else {
      result += c;
    }
  }
  return result;
}

std::string text_of(const Value& value, const Placeholder& placeholder) {
  if (const auto* text = std::get_if<std::string>(&value)) {
    if (placeholder.scaled) throw UsageError("{" + placeholder.name + "} is a text and cannot be multiplied");
    return *text;
  }
  if (const auto* whole = std::get_if<long long>(&value)) {
    if (!placeholder.scaled) return fmt::format("{}", *whole);
    return fmt::format("{}", std::llround(static_cast<double>(*whole) * placeholder.factor));
  }
  return fmt::format("{}", std::get<double>(value) * placeholder.factor);
}

}  // namespace

std::vector<std::string> split_words(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t at = text.find_first_not_of(blanks); at < text.size(); at = text.find_first_not_of(blanks, at)) {
    words.push_back(next_word(text, at));
  }
  return words;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += ' ';
    if (!word.empty() && word.find_first_of(" \t\r\n'\"\\") == std::string::npos) {
      text += word;
      continue;
    }
    text += '\'';
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    text += '\'';
  }
  return text;
}

std::vector<std::string> placeholders_in(const std::string& word) {
  std::vector<std::string> names;
  replaced(word, [&names](const Placeholder& placeholder) {
    names.push_back(placeholder.name);
    return std::string();
  });
  return names;
}

std::string filled(const std::string& word, const std::map<std::string, Value>& values) {
  return replaced(word, [&values](const Placeholder& placeholder) {
    const auto value = values.find(placeholder.name);
    if (value == values.end()) throw UsageError("unknown placeholder {" + placeholder.name + "}");
    return text_of(value->second, placeholder);
  });
}

}  // namespace isobench::external
