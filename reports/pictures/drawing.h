// What the program isobench-pictures does: everything of <folder>/pictures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/reports/runs/results.h"

namespace isobench {

/// Draws what files_of() names and is not there yet. Returns a sentence for each group of which not all could be drawn.
std::vector<std::string> draw_pictures(const Results& results, const std::filesystem::path& folder);

}  // namespace isobench
