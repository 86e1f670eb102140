// The files of samples that a header names: one, a list, or a pattern with numbers.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "isobench/datasets/formats/reading/byte_reader.h"

namespace isobench {

/// A name such as "slice%03d.raw" and the numbers that take the place of %03d: first, first + step and so on to last.
struct FilePattern {
  std::string before;  ///< the number
  std::string after;
  std::size_t width = 0;  ///< the least number of characters of a number
  bool zeros = false;     ///< fill up with zeros, not with blanks
  long long first = 0;
  long long last = 0;
  long long step = 1;

  /// At least 1.
  std::size_t count() const;
  std::string name(std::size_t n) const;
};

/// How an array is divided among files of equal size.
struct FileParts {
  std::size_t files = 1;
  std::size_t axes = 1;  ///< of the array in each file; if it is that of the whole, each has a part of the slowest axis
};

/// Reads a pattern. A name comes from a file, so only %d, %i and %u with a width and a leading 0 are understood; no
/// function of C ever gets it as a format. Throws DataError naming the header otherwise, if the name has no or several
/// numbers, if `step` is 0 or leads away from `last`.
FilePattern file_pattern(const std::string& name, long long first, long long last, long long step,
                         const std::filesystem::path& header);

/// The whole numbers at the end of a text, at most `most` of them, and what stands before them.
struct TextAndNumbers {
  std::string text;
  std::vector<long long> numbers;
};
TextAndNumbers numbers_at_end(const std::string& text, std::size_t most);

/// Throws DataError naming the header if an array of these sizes cannot be divided so. Precondition: the sizes' product
/// fits into long long.
void check_parts(const FileParts& parts, std::span<const long long> sizes, const std::filesystem::path& header);

/// The file with this name, relative to the header's folder. Throws DataError naming the header if it is missing or not
/// a file; `place` says which it is of several, e.g. "3 of 40", "" if it is the only one.
std::filesystem::path data_file_beside(const std::filesystem::path& header, const std::string& name,
                                       const std::string& place = "");

std::vector<DataFile> files_of_pattern(const FilePattern& pattern, const std::filesystem::path& header);

/// The names in the lines that follow, one each, until an empty line or the end. Throws DataError naming the header if
/// there are none.
std::vector<std::string> names_of_list(ByteReader& reader);
std::vector<DataFile> files_of_list(const std::vector<std::string>& names, const std::filesystem::path& header);

}  // namespace isobench
