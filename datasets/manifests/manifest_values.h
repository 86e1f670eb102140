// Readers of single values of a manifest.
#pragma once

#include <fmt/format.h>

#include <initializer_list>
#include <string>
#include <vector>

#include "isobench/foundation/error.h"
#include "isobench/foundation/toml.h"

namespace isobench {

/// The choice that a word names; the first choice if the key is absent. Throws UsageError for another word.
template <class Choice>
Choice parse_choice(const TomlValue& table, const char* key, std::initializer_list<Choice> choices) {
  const auto value = table.find(key);
  if (!value) return *choices.begin();
  const std::string word = value->as_string();
  std::vector<std::string> words;
  for (const Choice choice : choices) {
    words.emplace_back(to_string(choice));
    if (word == words.back()) return choice;
  }
  throw UsageError(value->place(), fmt::format("unknown {} '{}'{}", key, word, suggestion(word, words)));
}

}  // namespace isobench
