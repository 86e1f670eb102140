// Errors of finite elements over the number of vertices and over seconds.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <limits>

#include "isobench/reports/plots/plots.h"
#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/runs/refinement.h"
#include "isobench/reports/runs/timing.h"

namespace isobench {

namespace {

struct ErrorFigure {
  const char* figure;
  const char* file;   ///< in the plot's name
  const char* words;  ///< on its axis
  double order;       ///< in h, as the theory of linear elements has it
};
constexpr ErrorFigure error_figures[] = {
    {"poisson_l2", "poisson-l2", "root mean square error of a Poisson problem", 2.0},
    {"poisson_max", "poisson-max", "largest nodal error of a Poisson problem", 2.0},
    {"gradient_max", "gradient-max", "largest error of an interpolated gradient", 1.0}};

// Several series share a plot; each method keeps its colour in all plots of errors.
std::vector<std::string> labels_in_order(const std::vector<Refinement>& all) {
  std::vector<std::string> labels;
  for (const Refinement& refinement : all) {
    if (std::find(labels.begin(), labels.end(), refinement.label) == labels.end()) labels.push_back(refinement.label);
  }
  return labels;
}

using LevelRuns = std::function<Runs(const Runs&)>;

// One point for each sizing that has both values: the medians over seeds and repeats.
Series error_series(const Refinement& refinement, std::size_t colour, const LevelRuns& counted, const Figure& x,
                    const Figure& y) {
  Series series{refinement.label, colour, {}, {}};
  for (const Runs& level : refinement.levels) {
    std::vector<double> of_x;
    std::vector<double> of_y;
    for (const RunRecord* run : counted(level)) {
      of_x.push_back(x(*run));
      of_y.push_back(y(*run));
    }
    const double at = spread_of(std::move(of_x)).median;
    const double error = spread_of(std::move(of_y)).median;
    if (!(at > 0.0) || !(error > 0.0)) continue;  // the axes are logarithmic
    series.x.push_back(at);
    series.y.push_back(error);
  }
  return series;
}

Plot error_plot(const std::vector<Refinement>& all, const std::string& dataset, const ErrorFigure& error,
                const LevelRuns& counted, const Figure& x) {
  Plot plot;
  plot.title = fmt::format("{}, {}", error.words, dataset);
  plot.title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(plot.title.front())));
  plot.y_label = error.figure;
  plot.marks = Marks::joined;
  plot.log_x = plot.log_y = true;
  const std::vector<std::string> labels = labels_in_order(all);
  for (const Refinement& refinement : all) {
    if (refinement.dataset != dataset) continue;
    const auto label = std::find(labels.begin(), labels.end(), refinement.label);
    Series series =
        error_series(refinement, static_cast<std::size_t>(label - labels.begin()), counted, x, figure_of(error.figure));
    if (!series.x.empty()) plot.series.push_back(std::move(series));
  }
  return plot;
}

// A line below all points, as an error ~ hᵖ would fall: h ~ vertices^−½.
Series order_guide(const Plot& plot, double order) {
  constexpr std::size_t dashed_black = 20;
  constexpr double below = 0.7;
  double first = std::numeric_limits<double>::infinity();
  double last = 0.0;
  double factor = std::numeric_limits<double>::infinity();
  for (const Series& series : plot.series) {
    for (std::size_t n = 0; n < series.x.size(); ++n) {
      first = std::min(first, series.x[n]);
      last = std::max(last, series.x[n]);
      factor = std::min(factor, series.y[n] * std::pow(series.x[n], 0.5 * order));
    }
  }
  const auto at = [&](double x) { return below * factor * std::pow(x, -0.5 * order); };
  return {fmt::format("order {} in h", order), dashed_black, {first, last}, {at(first), at(last)}, {}, Marks::lines};
}

// Methods that mesh the lattice have the same point at each sizing.
bool has_curve(const Plot& plot) {
  return std::any_of(plot.series.begin(), plot.series.end(),
                     [](const Series& series) { return series.x.front() != series.x.back(); });
}

// gnuplot would leave room up to the next powers of ten.
void fit_axes(Plot& plot) {
  constexpr double margin = 1.3;
  plot.x_low = plot.y_low = std::numeric_limits<double>::infinity();
  for (const Series& series : plot.series) {
    const auto [left, right] = std::minmax_element(series.x.begin(), series.x.end());
    const auto [lowest, highest] = std::minmax_element(series.y.begin(), series.y.end());
    plot.x_low = std::min(plot.x_low, *left / margin);
    plot.x_high = std::max(plot.x_high, *right * margin);
    plot.y_low = std::min(plot.y_low, *lowest / margin);
    plot.y_high = std::max(plot.y_high, *highest * margin);
  }
}

// None where each method has one sizing: at equal numbers of vertices the points would form a column.
Plot error_over_vertices(const std::vector<Refinement>& all, const std::string& dataset, const ErrorFigure& error) {
  Plot plot = error_plot(all, dataset, error, counted_runs, figure_of("vertices"));
  if (!has_curve(plot)) return {};
  plot.kind = std::string(error.file) + "-over-vertices";
  plot.name = plot.kind + "-" + dataset;
  plot.caption = fmt::format(
      "One point for each sizing: the median over seeds and repeats. Lower is better. The dashed line has the order of "
      "linear elements, {}. Methods that mesh the lattice whatever the sizing have a single point.",
      error.order);
  plot.x_label = "vertices";
  plot.series.push_back(order_guide(plot, error.order));
  fit_axes(plot);
  return plot;
}

double meshing_and_solving(const RunRecord& run) { return run.seconds_total + solving_seconds(run); }

Plot error_over_seconds(const RunGrid& runs, const std::vector<Refinement>& all, const std::string& dataset,
                        const ErrorFigure& error) {
  const auto alike = [&runs](const Runs& level) { return runs_with_timing(counted_runs(level), runs.timing); };
  Plot plot = error_plot(all, dataset, error, alike, meshing_and_solving);
  if (plot.empty()) return plot;
  fit_axes(plot);
  plot.kind = std::string(error.file) + "-over-seconds";
  plot.name = plot.kind + "-" + dataset;
  plot.caption =
      "Wall seconds of sizing and method, and of factorising and solving one Poisson problem on the mesh (sparse "
      "Cholesky, one thread). Nearer to the lower left corner is better.";
  if (const std::string remark = timing_remark(runs); !remark.empty()) plot.caption += " " + remark;
  plot.x_label = "seconds of meshing and solving";
  return plot;
}

}  // namespace

std::vector<Plot> use_plots(const Results& results, const RunGrid& runs) {
  std::vector<Plot> plots;
  if (has_many_datasets(runs)) return plots;
  const std::vector<Refinement> all = refinements(results);
  for (const std::string& dataset : runs.datasets) {
    for (const ErrorFigure& error : error_figures) plots.push_back(error_over_vertices(all, dataset, error));
    for (const ErrorFigure& error : error_figures) plots.push_back(error_over_seconds(runs, all, dataset, error));
  }
  std::erase_if(plots, [](const Plot& plot) { return plot.empty(); });
  return plots;
}

}  // namespace isobench
