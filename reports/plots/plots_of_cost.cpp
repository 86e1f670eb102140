// Plots of time, of traces, and of quality over the number of vertices and over ε and δ.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "isobench/reports/plots/plots.h"
#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/runs/timing.h"
#include "isobench/reports/tables/sizing_grid.h"

namespace isobench {

namespace {

// "mesh/relaxation" → "relaxation"; "" for a stage that is not directly under "mesh".
std::string part_of_meshing(const std::string& stage) {
  static const std::string outer = "mesh/";
  if (!stage.starts_with(outer) || stage.find('/', outer.size()) != std::string::npos) return "";
  return stage.substr(outer.size());
}

// Seconds of one part of a run. "rest" is the time that no part accounts for.
double seconds_of(const RunRecord& run, const std::string& part) {
  double sum = 0.0;
  for (const StageTime& stage : run.stages) {
    const std::string name = part_of_meshing(stage.name);
    if (name.empty()) continue;
    if (name == part) return stage.wall_seconds;
    sum += stage.wall_seconds;
  }
  return part == "rest" ? std::max(0.0, run.seconds_total - sum) : 0.0;
}

// The parts of all runs, in the order in which they first occur, then "rest".
std::vector<std::string> parts_of(const Runs& runs) {
  std::vector<std::string> parts;
  for (const RunRecord* run : runs) {
    for (const StageTime& stage : run->stages) {
      const std::string name = part_of_meshing(stage.name);
      if (!name.empty() && std::find(parts.begin(), parts.end(), name) == parts.end()) parts.push_back(name);
    }
  }
  parts.emplace_back("rest");
  return parts;
}

// The end of a caption: which runs' seconds are compared.
std::string timing_note(const RunGrid& runs) {
  const std::string remark = timing_remark(runs);
  return remark.empty() ? "" : " " + remark;
}

double vertices_of(const RunRecord& run) { return run.measurement->number("vertices"); }

// The runs that a scatter plot shows. A plot of seconds shows only runs that were timed alike.
Runs plotted_runs(const RunGrid& runs, const Variant& variant, const std::string& dataset, bool timed) {
  const Runs all = finished(find_runs(variant, dataset));
  return timed ? runs_with_timing(all, runs.timing) : all;
}

std::size_t number_plotted(const RunGrid& runs, bool timed) {
  std::size_t count = 0;
  for (const Variant& variant : runs.variants) {
    for (const std::string& dataset : runs.datasets) count += plotted_runs(runs, variant, dataset, timed).size();
  }
  return count;
}

double median_of(const Runs& runs, const Figure& figure) {
  std::vector<double> values;
  for (const RunRecord* run : runs) values.push_back(figure(*run));
  return spread_of(std::move(values)).median;
}

// "Each point is a finished run." or what stands for runs that are too many.
std::string points_sentence(bool medians, std::size_t stride) {
  std::string text = medians ? "Each point is a median over seeds and repeats." : "Each point is a finished run.";
  if (stride > 1)
    text += fmt::format(" Of every {} data sets only the first is shown, so that points can be seen.", stride);
  return text;
}

// One point for each finished run on any data set. If these are too many, one point for all seeds and repeats of a
// method on a data set. If these are too many, too, not all data sets are shown.
Plot over_vertices(const RunGrid& runs, const std::string& name, const std::string& y_label, const Figure& y,
                   bool timed = false) {
  constexpr std::size_t most_points = 2000;
  const bool too_many = number_plotted(runs, timed) > most_points;
  const std::size_t stride = has_many_datasets(runs) && too_many
                                 ? (runs.variants.size() * runs.datasets.size() + most_points - 1) / most_points
                                 : 1;
  Plot plot;
  plot.name = name + "-over-vertices";
  plot.title = y_label + " over the number of vertices, all data sets";
  plot.caption = points_sentence(too_many, stride) + (timed ? timing_note(runs) : "");
  plot.x_label = "vertices";
  plot.y_label = y_label;
  plot.marks = Marks::points;
  plot.log_x = true;
  for (std::size_t n = 0; n < runs.variants.size(); ++n) {
    Series series{runs.variants[n].name, n, {}, {}};
    for (std::size_t d = 0; d < runs.datasets.size(); d += stride) {
      const Runs group = plotted_runs(runs, runs.variants[n], runs.datasets[d], timed);
      if (too_many && !group.empty()) {
        series.x.push_back(median_of(group, vertices_of));
        series.y.push_back(median_of(group, y));
        continue;
      }
      for (const RunRecord* run : group) {
        series.x.push_back(vertices_of(*run));
        series.y.push_back(y(*run));
      }
    }
    if (!series.x.empty()) plot.series.push_back(std::move(series));
  }
  return plot;
}

Plot grid_plot(const SizingGrid& grid, const std::string& name, const std::string& label, const Figure& figure) {
  Plot plot;
  plot.name = fmt::format("{}-over-sizing-{}-{}", name, grid.dataset, grid.label);
  plot.title = fmt::format("{} over δ and ε, {}, {}", label, grid.dataset, grid.label);
  plot.caption =
      "Medians over the seeds. With a smaller δ the edge length changes more slowly. With a smaller ε the sampling is "
      "denser.";
  plot.x_label = "δ";
  plot.y_label = label;
  plot.marks = Marks::joined;
  for (std::size_t e = 0; e < grid.epsilons.size(); ++e) {
    Series series{fmt::format("ε = {}", grid.epsilons[e]), e, {}, {}};
    std::vector<double> deltas = grid.deltas;
    std::sort(deltas.begin(), deltas.end());
    for (const double delta : deltas) {
      const auto cell = grid.cells.find({grid.epsilons[e], delta});
      if (cell == grid.cells.end()) continue;
      const Runs counted = counted_runs(cell->second);
      if (counted.empty()) continue;
      series.x.push_back(delta);
      series.y.push_back(median_of(counted, figure));
    }
    if (!series.x.empty()) plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace

std::vector<Plot> trace_plots(const RunGrid& runs) {
  std::vector<Plot> plots;
  for (const std::string& dataset : runs.datasets) {
    std::set<std::string> names;
    for (const Variant& variant : runs.variants) {
      const RunRecord* run = find_run(variant, dataset);
      if (run == nullptr) continue;
      for (const auto& [name, values] : run->traces) names.insert(name);
    }
    for (const std::string& name : names) {
      Plot plot;
      plot.name = fmt::format("trace-{}-{}", name, dataset);
      plot.title = fmt::format("{} at each step, {}", name, dataset);
      plot.caption = "One value for each step, as the method recorded it, from one run of each method.";
      plot.x_label = "step";
      plot.y_label = name;
      for (std::size_t n = 0; n < runs.variants.size(); ++n) {
        const RunRecord* run = find_run(runs.variants[n], dataset);
        if (run == nullptr || !run->traces.contains(name)) continue;
        Series series{runs.variants[n].name, n, {}, run->traces.at(name)};
        for (std::size_t step = 0; step < series.y.size(); ++step) series.x.push_back(static_cast<double>(step + 1));
        if (!series.x.empty()) plot.series.push_back(std::move(series));
      }
      if (!plot.empty()) plots.push_back(std::move(plot));
    }
  }
  return plots;
}

std::vector<Plot> stage_plots(const RunGrid& runs) {
  std::vector<Plot> plots;
  for (const std::string& dataset : runs.datasets) {
    Plot plot;
    plot.name = "stages-" + dataset;
    plot.title = "Seconds by stage, " + dataset;
    plot.caption =
        "Wall seconds from the prepared volume to the mesh, from one run of each method. Shorter is better." +
        timing_note(runs);
    plot.x_label = "";
    plot.y_label = "seconds";
    plot.marks = Marks::stack;
    Runs shown;
    for (const Variant& variant : runs.variants) {
      const Runs alike = runs_with_timing(finished(find_runs(variant, dataset)), runs.timing);
      if (alike.empty()) continue;
      shown.push_back(alike.front());
      plot.categories.push_back(variant.name);
    }
    if (shown.empty()) continue;
    for (const std::string& part : parts_of(shown)) {
      Series series{part, plot.series.size(), {}, {}};
      for (std::size_t n = 0; n < shown.size(); ++n) {
        series.x.push_back(static_cast<double>(n));
        series.y.push_back(seconds_of(*shown[n], part));
      }
      plot.series.push_back(std::move(series));
    }
    plots.push_back(std::move(plot));
  }
  return plots;
}

std::vector<Plot> size_plots(const RunGrid& runs) {
  std::vector<Plot> plots;
  plots.push_back(over_vertices(runs, "radius-ratio-min", "smallest radius ratio", figure_of("radius_ratio_min")));
  plots.push_back(over_vertices(runs, "radius-ratio-avg", "average radius ratio", figure_of("radius_ratio_avg")));
  plots.push_back(over_vertices(runs, "seconds", "seconds", figure_of("seconds_total"), true));
  plots.back().log_y = true;
  std::erase_if(plots, [](const Plot& plot) { return plot.empty(); });
  return plots;
}

std::vector<Plot> sizing_plots(const Results& results) {
  std::vector<Plot> plots;
  for (const SizingGrid& grid : sizing_grids(results)) {
    plots.push_back(grid_plot(grid, "radius-ratio-min", "smallest radius ratio", figure_of("radius_ratio_min")));
    plots.push_back(grid_plot(grid, "radius-ratio-avg", "average radius ratio", figure_of("radius_ratio_avg")));
    plots.push_back(grid_plot(grid, "vertices", "vertices", vertices_of));
    plots.push_back(grid_plot(grid, "distance", "mean distance to the surface, mm", figure_of("distance_mean")));
  }
  std::erase_if(plots, [](const Plot& plot) { return plot.empty(); });
  return plots;
}

}  // namespace isobench
