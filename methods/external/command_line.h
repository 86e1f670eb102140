// A command line as one text: split into words without any shell, and its placeholders filled in.
#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace isobench::external {

/// Words as a POSIX shell would split them, quotes and backslashes included, and nothing else of a shell: no variables,
/// globs, pipes or redirections. Throws UsageError for a quote that is not closed.
std::vector<std::string> split_words(const std::string& text);
/// Words as one text again that split_words() takes apart to the same.
std::string joined(const std::vector<std::string>& words);

/// A number, a whole number that is to be written as one, or a text such as a file's name.
using Value = std::variant<double, long long, std::string>;

/// The names of the placeholders in a word, in order: {name}, {name*factor} or {name/divisor}; "{{" and "}}" stand for
/// braces. Throws UsageError for a brace that is not closed and for a factor that is no number > 0.
std::vector<std::string> placeholders_in(const std::string& word);
/// The word with values in the place of its placeholders; whole numbers are rounded after the factor was applied.
/// Throws UsageError for a name without a value, or a factor on a text.
std::string filled(const std::string& word, const std::map<std::string, Value>& values);

}  // namespace isobench::external
