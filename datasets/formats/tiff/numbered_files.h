// Files that are the slices of a stack, by the numbers in their names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace isobench {

/// Whether the file's name is a pattern: it has a "*", or a "%d" or "%03d" as printf takes it, for the number.
bool is_file_pattern(const std::filesystem::path& path);

/// The files of a folder whose names match the pattern, or end with one of `endings` (in lower case), without hidden
/// ones. Sorted by name.
std::vector<std::filesystem::path> files_matching(const std::filesystem::path& pattern);
std::vector<std::filesystem::path> files_ending(const std::filesystem::path& folder,
                                                const std::vector<std::string>& endings);

/// Files whose names differ in one number alone, in the order of this number: 2 comes before 10. Throws DataError
/// naming `path` where names differ in something else, or where a number is missing: where one of the steps from each
/// number to the next is larger than the others.
std::vector<std::filesystem::path> in_order_of_numbers(std::vector<std::filesystem::path> files,
                                                       const std::filesystem::path& path);

}  // namespace isobench
