#include "isobench/datasets/formats/reading/data_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

[[noreturn]] void throw_bad_pattern(const std::string& name, const std::filesystem::path& header) {
  throw DataError(
      fmt::format("{}: its pattern of data files '{}' is not understood; write one number in it as %d or %03d, and its "
                  "first value, "
                  "last value and step after it",
                  header.string(), name, name));
}

std::optional<long long> whole_number(std::string_view word) {
  long long number = 0;
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || rest != word.data() + word.size()) return std::nullopt;
  return number;
}

/// Takes the number's format from `name` at `at`, behind the %. Returns where it ends; npos if it is no such format.
std::size_t take_number_format(const std::string& name, std::size_t at, FilePattern& pattern) {
  if (at < name.size() && name[at] == '0') pattern.zeros = true;
  std::size_t digits = 0;
  for (; at < name.size() && name[at] >= '0' && name[at] <= '9'; ++at) {
    pattern.width = 10 * pattern.width + static_cast<std::size_t>(name[at] - '0');
    if (++digits > 2) return std::string::npos;
  }
  const bool is_number = at < name.size() && (name[at] == 'd' || name[at] == 'i' || name[at] == 'u');
  return is_number ? at + 1 : std::string::npos;
}

}  // namespace

std::size_t FilePattern::count() const { return static_cast<std::size_t>((last - first) / step) + 1; }

std::string FilePattern::name(std::size_t n) const {
  const long long number = first + static_cast<long long>(n) * step;
  return before + (zeros ? fmt::format("{:0{}d}", number, width) : fmt::format("{:{}d}", number, width)) + after;
}

FilePattern file_pattern(const std::string& name, long long first, long long last, long long step,
                         const std::filesystem::path& header) {
  FilePattern pattern;
  pattern.first = first;
  pattern.last = last;
  pattern.step = step;
  bool found = false;
  for (std::size_t at = 0; at < name.size(); ++at) {
    std::string& part = found ? pattern.after : pattern.before;
    if (name[at] != '%') {
      part.push_back(name[at]);
    } else if (at + 1 < name.size() && name[at + 1] == '%') {
      part.push_back(name[at++]);
    } else {
      const std::size_t end = found ? std::string::npos : take_number_format(name, at + 1, pattern);
      if (end == std::string::npos) throw_bad_pattern(name, header);
      found = true;
      at = end - 1;
    }
  }
  constexpr long long limit = std::numeric_limits<int>::max();
  const auto is_small = [&](long long number) { return number >= -limit && number <= limit; };
  if (!found || !is_small(first) || !is_small(last) || !is_small(step)) throw_bad_pattern(name, header);
  if (step == 0 || (last > first && step < 0) || (last < first && step > 0)) {
    throw DataError(fmt::format("{}: its pattern of data files counts from {} to {} in steps of {}; correct its header",
                                header.string(), first, last, step));
  }
  return pattern;
}

TextAndNumbers numbers_at_end(const std::string& text, std::size_t most) {
  TextAndNumbers result{trimmed(text), {}};
  while (result.numbers.size() < most) {
    const std::size_t blank = result.text.find_last_of(" \t");
    if (blank == std::string::npos) break;
    const auto number = whole_number(std::string_view(result.text).substr(blank + 1));
    if (!number) break;
    result.numbers.insert(result.numbers.begin(), *number);
    result.text = trimmed(result.text.substr(0, blank));
  }
  return result;
}

void check_parts(const FileParts& parts, std::span<const long long> sizes, const std::filesystem::path& header) {
  if (parts.axes < 1 || parts.axes > sizes.size()) {
    throw DataError(fmt::format("{}: its data files cannot have {} of its {} dimensions; correct its header",
                                header.string(), parts.axes, sizes.size()));
  }
  const auto files = static_cast<long long>(parts.files);
  if (parts.axes == sizes.size()) {
    if (files >= 1 && sizes.back() % files == 0) return;
    throw DataError(
        fmt::format("{}: {} places of its last axis cannot be divided among {} data files; correct its header",
                    header.string(), sizes.back(), files));
  }
  long long expected = 1;
  for (std::size_t axis = parts.axes; axis < sizes.size(); ++axis) expected *= sizes[axis];
  if (files != expected) {
    throw DataError(fmt::format("{}: it names {} data file{}, but its sizes make {}; correct its header",
                                header.string(), files, files == 1 ? "" : "s", expected));
  }
}

std::filesystem::path data_file_beside(const std::filesystem::path& header, const std::string& name,
                                       const std::string& place) {
  std::error_code error;
  std::filesystem::path path = header.parent_path() / name;
  if (!std::filesystem::exists(path, error) && name.find('\\') != std::string::npos) {
    // Written under Windows.
    std::string with_slashes = name;
    std::replace(with_slashes.begin(), with_slashes.end(), '\\', '/');
    path = header.parent_path() / with_slashes;
  }
  if (!name.empty() && std::filesystem::is_regular_file(path, error)) return path;
  throw DataError(fmt::format("{}: its data file '{}'{} is {}; put it where its header says", header.string(), name,
                              place.empty() ? "" : ", " + place + ",",
                              std::filesystem::exists(path, error) ? "not a file" : "missing"));
}

std::vector<DataFile> files_of_pattern(const FilePattern& pattern, const std::filesystem::path& header) {
  const std::size_t count = pattern.count();
  std::vector<DataFile> files;  // grows only as far as there are files, whatever the header says
  for (std::size_t n = 0; n < count; ++n)
    files.push_back({data_file_beside(header, pattern.name(n), fmt::format("{} of {}", n + 1, count))});
  return files;
}

std::vector<std::string> names_of_list(ByteReader& reader) {
  std::vector<std::string> names;
  std::string line;
  while (reader.read_line(line) && !trimmed(line).empty()) names.push_back(trimmed(line));
  if (names.empty())
    throw DataError(reader.path().string() + ": its list of data files is empty; copy or export it again");
  return names;
}

std::vector<DataFile> files_of_list(const std::vector<std::string>& names, const std::filesystem::path& header) {
  std::vector<DataFile> files;
  for (const std::string& name : names) {
    files.push_back({data_file_beside(header, name, fmt::format("{} of {}", files.size() + 1, names.size()))});
  }
  return files;
}

}  // namespace isobench
