// Plots drawn by gnuplot as SVG.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/reports/plots/plot.h"

namespace isobench {

/// A script that draws a plot into <name>.svg, its numbers included: whoever wants it another way changes the script.
std::string gnuplot_script(const Plot& plot);

/// What a set of plots came to: which of them are there as SVG now, and a sentence on what is missing and how to get
/// it.
struct Drawn {
  std::vector<std::string> names;
  std::string missing;  ///< "" where nothing is
};

/// Makes <folder>/<name>.gp and <folder>/<name>.svg of each plot and removes what was there of others. One that is
/// there already by the same script is kept. Without gnuplot there are the scripts alone.
Drawn draw(const std::vector<Plot>& plots, const std::filesystem::path& folder);

}  // namespace isobench
