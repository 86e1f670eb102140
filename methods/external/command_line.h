// A command line given as one text: splits it into words without a shell and fills in placeholders.
#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace isobench::external {

/// Splits a text into words as a POSIX shell does, with quotes and backslashes, but without variables, globs, pipes and
/// redirections. Throws UsageError for a quote that is not closed.
std::vector<std::string> split_words(const std::string& text);
/// The inverse: a text that split_words() splits into these words.
std::string joined(const std::vector<std::string>& words);

/// A number, a number that is written as a whole one, or a text such as the name of a file.
using Value = std::variant<double, long long, std::string>;

/// The names of the placeholders in a word, in order. A placeholder is {name}, {name*factor} or {name/divisor}; "{{"
/// and
/// "}}" stand for braces. Throws UsageError for a brace that is not closed and for a factor that is not a number > 0.
std::vector<std::string> placeholders_in(const std::string& word);
/// The word with its placeholders replaced by their values. A whole number times a factor is rounded. Throws UsageError
/// for a name without a value and for a text with a factor.
std::string filled(const std::string& word, const std::map<std::string, Value>& values);

}  // namespace isobench::external
