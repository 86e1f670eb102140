// Draws the files of <folder>/pictures, in the program isobench-pictures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/reports/runs/results.h"

namespace isobench {

/// Draws the files that files_of() names and that do not exist yet. Returns one sentence for each group with a picture
/// that could not be drawn.
std::vector<std::string> draw_pictures(const Results& results, const std::filesystem::path& folder);

}  // namespace isobench
