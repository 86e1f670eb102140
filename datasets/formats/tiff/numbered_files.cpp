#include "isobench/datasets/formats/tiff/numbered_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The pattern with "*" for each number.
std::string with_stars(const std::string& pattern) {
  std::string text;
  for (std::size_t at = 0; at < pattern.size(); ++at) {
    std::size_t end = at + 1;
    while (pattern[at] == '%' && end < pattern.size() && is_digit(pattern[end])) ++end;
    const bool is_number = pattern[at] == '%' && end < pattern.size() && (pattern[end] == 'd' || pattern[end] == 'i');
    text += is_number ? '*' : pattern[at];
    if (is_number) at = end;
  }
  return text;
}

/// Whether a name matches a pattern with "*" for any characters. Takes the earliest place for each part between them.
bool matches(std::string_view name, std::string_view pattern) {
  const std::size_t first = pattern.find('*');
  if (first == std::string_view::npos) return name == pattern;
  if (!name.starts_with(pattern.substr(0, first))) return false;
  name.remove_prefix(first);
  for (pattern.remove_prefix(first + 1);;) {
    const std::size_t next = pattern.find('*');
    if (next == std::string_view::npos) return name.ends_with(pattern);
    const std::size_t at = name.find(pattern.substr(0, next));
    if (at == std::string_view::npos) return false;
    name.remove_prefix(at + next);
    pattern.remove_prefix(next + 1);
  }
}

template <class Meant>
std::vector<fs::path> files_in_folder(const fs::path& folder, Meant&& is_meant) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    std::error_code unknown;
    if (!name.starts_with('.') && is_meant(name) && fs::is_regular_file(entry->path(), unknown))
      files.push_back(entry->path());
  }
  if (error) throw DataError(folder.string() + ": cannot be read: " + error.message());
  std::sort(files.begin(), files.end());
  return files;
}

/// A name, cut into its numbers and the text around them.
struct NameParts {
  fs::path file;
  std::string text;  ///< with "#" for each number
  std::vector<unsigned long long> numbers;
};

NameParts parts_of(const fs::path& file) {
  NameParts parts{file, "", {}};
  const std::string name = file.filename().string();
  for (std::size_t at = 0; at < name.size();) {
    if (!is_digit(name[at])) {
      parts.text += name[at++];
      continue;
    }
    unsigned long long number = 0;
    // 18 digits always fit; longer ones are cut into several numbers.
    for (const std::size_t begin = at; at < name.size() && is_digit(name[at]) && at < begin + 18; ++at)
      number = 10 * number + static_cast<unsigned long long>(name[at] - '0');
    parts.text += '#';
    parts.numbers.push_back(number);
  }
  return parts;
}

/// The only place at which numbers differ. Precondition: there are two names at least, with the same texts.
std::size_t counting_place(const std::vector<NameParts>& names, const fs::path& path) {
  std::vector<std::size_t> differing;
  for (std::size_t place = 0; place < names.front().numbers.size(); ++place) {
    const auto differs = [&](const NameParts& name) { return name.numbers[place] != names.front().numbers[place]; };
    if (std::any_of(names.begin(), names.end(), differs)) differing.push_back(place);
  }
  if (differing.size() == 1) return differing.front();
  throw DataError(
      fmt::format("{}: {} files like {} are numbered in {} places of their names; give a pattern with * for the number "
                  "of the slice",
                  path.string(), names.size(), names.front().file.filename().string(), differing.size()));
}

}  // namespace

bool is_file_pattern(const fs::path& path) {
  return with_stars(path.filename().string()).find('*') != std::string::npos;
}

std::vector<fs::path> files_matching(const fs::path& pattern) {
  const std::string stars = with_stars(pattern.filename().string());
  const fs::path folder = pattern.has_parent_path() ? pattern.parent_path() : fs::path(".");
  return files_in_folder(folder, [&](const std::string& name) { return matches(name, stars); });
}

std::vector<fs::path> files_ending(const fs::path& folder, const std::vector<std::string>& endings) {
  return files_in_folder(folder, [&](const std::string& name) {
    const std::string lower = lower_case(name);
    return std::any_of(endings.begin(), endings.end(), [&](const std::string& end) { return lower.ends_with(end); });
  });
}

std::vector<fs::path> in_order_of_numbers(std::vector<fs::path> files, const fs::path& path) {
  if (files.size() < 2) return files;
  std::vector<NameParts> names;
  for (const fs::path& file : files) names.push_back(parts_of(file));
  const auto other =
      std::find_if(names.begin(), names.end(), [&](const NameParts& name) { return name.text != names.front().text; });
  if (other != names.end()) {
    throw DataError(fmt::format(
        "{}: the names {} and {} differ in more than a number; give a pattern with * for the number of the slice",
        path.string(), names.front().file.filename().string(), other->file.filename().string()));
  }
  const std::size_t place = counting_place(names, path);
  const auto number = [place](const NameParts& name) { return name.numbers[place]; };
  std::stable_sort(names.begin(), names.end(),
                   [&](const NameParts& a, const NameParts& b) { return number(a) < number(b); });
  const unsigned long long step = number(names[1]) - number(names[0]);
  for (std::size_t n = 0; n < names.size(); ++n) {
    if (n > 0 && number(names[n]) - number(names[n - 1]) != step) {
      throw DataError(
          fmt::format("{}: the numbers of {} and {} are not as far apart as others; copy what is missing "
                      "between the files, or number them without gaps",
                      path.string(), names[n - 1].file.filename().string(), names[n].file.filename().string()));
    }
    files[n] = names[n].file;
  }
  return files;
}

}  // namespace isobench
