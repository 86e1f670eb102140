// Plots as SVG, drawn by gnuplot.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/reports/plots/plot.h"

namespace isobench {

/// A script that draws a plot into <name>.svg. It contains the numbers, so a reader can change the plot by hand.
std::string gnuplot_script(const Plot& plot);

/// The outcome of drawing several plots.
struct Drawn {
  std::vector<std::string> names;  ///< of the plots that have an SVG file now
  std::string missing;             ///< a sentence on what is missing, with the remedy; "" if nothing is
};

/// Writes <folder>/<name>.gp and <folder>/<name>.svg for each plot and removes all other files from the folder. A plot
/// whose script did not change is not drawn again. Without gnuplot only the scripts are written.
Drawn draw(const std::vector<Plot>& plots, const std::filesystem::path& folder);

}  // namespace isobench
