// All plots of a results folder, with names for files and no more series than a reader can tell apart.
#include "isobench/reports/plots/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>

namespace isobench {

namespace {

// Makes names fit for files: unique, and only of letters, digits, dots and dashes.
void make_file_names(std::vector<Plot>& plots) {
  std::set<std::string> taken;
  for (Plot& plot : plots) {
    const auto plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '.' || c == '-'; };
    std::replace_if(
        plot.name.begin(), plot.name.end(), [plain](char c) { return !plain(c); }, '-');
    const std::string name = plot.name;
    for (int n = 2; !taken.insert(plot.name).second; ++n) plot.name = fmt::format("{}-{}", name, n);
  }
}

// Readers cannot tell more series or categories apart.
constexpr std::size_t most_series = 16;
constexpr std::size_t most_categories = 24;

void keep_readable(Plot& plot) {
  if (plot.marks == Marks::stack && plot.categories.size() > most_categories) {
    plot.caption +=
        fmt::format(" Only the first {1} of {0} methods are shown.", plot.categories.size(), most_categories);
    plot.categories.resize(most_categories);
    for (Series& series : plot.series) {
      series.x.resize(std::min(series.x.size(), most_categories));
      series.y.resize(std::min(series.y.size(), most_categories));
    }
  }
  if (plot.marks != Marks::stack && plot.series.size() > most_series) {
    plot.caption += fmt::format(" Only the first {1} of {0} series are shown.", plot.series.size(), most_series);
    plot.series.resize(most_series);
  }
}

}  // namespace

std::vector<Plot> all_plots(const Results& results, const std::vector<EdgesOverH>& over_h) {
  const RunGrid runs = arrange_runs(results);
  std::vector<Plot> plots;
  const bool many = has_many_datasets(runs);
  const std::vector<Plot> none;
  for (std::vector<Plot> kind :
       {many ? survey_plots(runs) : none, use_plots(results, runs), radius_ratio_plots(runs), edge_length_plots(runs),
        contraction_plots(over_h), angle_plots(runs), valence_plots(runs), size_plots(runs),
        many ? none : stage_plots(runs), sizing_plots(results), many ? none : trace_plots(runs)}) {
    std::move(kind.begin(), kind.end(), std::back_inserter(plots));
  }
  make_file_names(plots);
  for (Plot& plot : plots) keep_readable(plot);
  return plots;
}

}  // namespace isobench
