// Plots over many data sets: distributions, cumulative shares, performance profiles, the Pareto front, ranks.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isobench/reports/plots/plots.h"
#include "isobench/reports/statistics/sample.h"
#include "isobench/reports/survey/side_by_side.h"
#include "isobench/reports/survey/survey.h"

namespace isobench {

namespace {

constexpr int curve_points = 300;

// A method has the same colour in all plots.
std::size_t colour_of_method(const RunGrid& runs, const Variant& method) {
  return static_cast<std::size_t>(&method - runs.variants.data());
}

Series box_series(const std::string& name, std::size_t colour, std::vector<double> values) {
  BoxPlot box = box_plot(std::move(values));
  return {name,
          colour,
          std::move(box.outliers),
          {},
          {box.low, box.lower_quartile, box.median, box.upper_quartile, box.high},
          {}};
}

// Seconds differ by orders of magnitude; so may what no good mesh does.
bool wants_log(const Criterion& criterion) { return criterion.timed; }

Plot boxes_of(const Criterion& criterion, const std::string& name, const std::string& title) {
  Plot plot;
  plot.name = name;
  plot.kind = "boxes";
  plot.title = title;
  plot.caption = fmt::format(
      "One value for each data set. The box has the middle half of the data sets, the line in it is the "
      "median. Circles are outliers, beyond 1.5 times the length of the box. {} values are better.",
      criterion.larger ? "Larger" : "Smaller");
  plot.x_label = name_with_unit(criterion);
  plot.marks = Marks::boxes;
  plot.log_x = wants_log(criterion);
  return plot;
}

Plot box_plot_of_methods(const RunGrid& runs, const Criterion& criterion) {
  Plot plot = boxes_of(criterion, "boxes-" + criterion.id, criterion.name + " over the data sets");
  for (const Variant* method : surveyed(runs)) {
    std::vector<double> values = values_over(runs, *method, criterion);
    if (!values.empty())
      plot.series.push_back(box_series(method->name, colour_of_method(runs, *method), std::move(values)));
  }
  return plot;
}

// The families of the method that ran on the most data sets.
Plot box_plot_of_families(const RunGrid& runs, const Criterion& criterion) {
  const std::vector<const Variant*> methods = surveyed(runs);
  const Variant& method = **std::max_element(methods.begin(), methods.end(), [](const Variant* a, const Variant* b) {
    return a->runs.size() < b->runs.size();
  });
  Plot plot =
      boxes_of(criterion, "families-" + criterion.id, fmt::format("{} by family, {}", criterion.name, method.name));
  for (const std::string& family : families_of(runs)) {
    std::vector<double> values = values_over(runs, method, criterion, family);
    if (!values.empty()) plot.series.push_back(box_series(family, colour_of_method(runs, method), std::move(values)));
  }
  return plot;
}

// How many percent of the data sets reach each value. A data set without a value reaches none.
Plot cumulative_plot(const RunGrid& runs, const Criterion& criterion, double low, double high) {
  Plot plot;
  plot.name = "share-" + criterion.id;
  plot.kind = "share";
  plot.title = fmt::format("{} {} x: share of surfaces", criterion.name, criterion.larger ? "≥" : "≤");
  plot.caption =
      "Each curve counts all data sets on which the method has a run. A data set without a mesh counts as worse than "
      "every x. A curve that is higher everywhere belongs to the better method.";
  plot.x_label = "x: " + name_with_unit(criterion);
  plot.y_label = "% of the data sets";
  plot.x_low = low;
  plot.x_high = high;
  plot.y_high = 102.0;
  for (const Variant* method : surveyed(runs)) {
    std::vector<double> values = values_over(runs, *method, criterion);
    std::sort(values.begin(), values.end());
    Series series{method->name, colour_of_method(runs, *method), {}, {}};
    const auto all = static_cast<double>(method->runs.size());
    for (int n = 0; n <= curve_points; ++n) {
      const double x = low + (high - low) * n / curve_points;
      const std::size_t count = criterion.larger ? count_at_least(values, x) : count_at_most(values, x);
      series.x.push_back(x);
      series.y.push_back(100.0 * static_cast<double>(count) / all);
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

// From 1 to where no curve rises any more, but not beyond 1000.
double end_of_profile(const Costs& ratios) {
  double end = 2.0;
  for (const std::vector<double>& method : ratios) {
    for (const double ratio : method) {
      if (std::isfinite(ratio)) end = std::max(end, ratio);
    }
  }
  return std::min(1.05 * end, 1000.0);
}

Plot profile_plot(const RunGrid& runs, const Criterion& criterion) {
  const SideBySide side = side_by_side(runs, criterion);
  Plot plot;
  plot.name = "profile-" + criterion.id;
  plot.kind = "profile";
  plot.title = "Performance profile: " + criterion.name;
  plot.caption = fmt::format(
      "Dolan and Moré 2002, over {} data sets on which every method has a run. At τ = 1 a curve shows on how many of "
      "them the method is the best. At the right it shows how many it can do at all: no closed manifold is a failure.",
      side.datasets.size());
  plot.x_label = criterion.larger ? "τ: the value is at least 1/τ of the best one"
                                  : "τ: the value is at most τ times the best one";
  plot.y_label = "% of the data sets";
  plot.y_high = 102.0;
  plot.log_x = true;
  const Costs ratios = performance_ratios(side.costs);
  const double end = end_of_profile(ratios);
  plot.x_low = 1.0;
  plot.x_high = end;
  for (std::size_t m = 0; m < side.methods.size(); ++m) {
    Series series{side.methods[m]->name, colour_of_method(runs, *side.methods[m]), {}, {}};
    for (int n = 0; n <= curve_points; ++n) {
      const double tau = std::pow(end, static_cast<double>(n) / curve_points);
      series.x.push_back(tau);
      series.y.push_back(100.0 * static_cast<double>(count_at_most(ratios[m], tau)) /
                         static_cast<double>(side.datasets.size()));
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

double median_over(const RunGrid& runs, const Variant& method, const std::vector<std::string>& datasets,
                   const Criterion& criterion) {
  std::vector<double> values;
  for (const std::string& dataset : datasets) values.push_back(value_on(runs, method, dataset, criterion));
  return spread_of(std::move(values)).median;
}

Plot pareto_plot(const RunGrid& runs, const Criterion& quality) {
  const Criterion& seconds = quality_criterion("seconds-per-1000-vertices");
  const std::vector<std::string> datasets = shared_datasets(runs);
  Plot plot;
  plot.name = "pareto-" + quality.id;
  plot.kind = "pareto";
  plot.title = quality.name + " against seconds: medians";
  plot.caption = fmt::format(
      "Medians over {} data sets on which every method has a run. The line joins the methods that no other one beats "
      "in "
      "both (the Pareto front). Up and to the left is better.",
      datasets.size());
  plot.x_label = seconds.name;
  plot.y_label = name_with_unit(quality);
  plot.marks = Marks::points;
  plot.log_x = true;
  std::vector<ParetoPoint> points;
  for (const Variant* method : surveyed(runs)) {
    const ParetoPoint point{median_over(runs, *method, datasets, seconds),
                            median_over(runs, *method, datasets, quality)};
    if (!std::isfinite(point.cost) || !std::isfinite(point.quality)) continue;
    points.push_back(point);
    plot.series.push_back({method->name, colour_of_method(runs, *method), {point.cost}, {point.quality}});
  }
  if (points.size() < 2) return {};
  constexpr std::size_t black = 6;
  Series front{"Pareto front", black, {}, {}, {}, Marks::lines};
  for (const std::size_t n : pareto_front(points)) {
    front.x.push_back(points[n].cost);
    front.y.push_back(points[n].quality);
  }
  if (front.x.size() > 1) plot.series.push_back(std::move(front));
  return plot;
}

Plot rank_plot(const RunGrid& runs, const Criterion& criterion) {
  const SideBySide side = side_by_side(runs, criterion);
  Plot plot;
  plot.name = "ranks-" + criterion.id;
  plot.kind = "ranks";
  plot.title = "Average ranks: " + criterion.name;
  const double difference = critical_difference(side.methods.size(), side.datasets.size());
  plot.caption = fmt::format(
      "Average rank of each method over {} data sets; 1 is the best. Each bar is as long as Nemenyi's critical "
      "difference "
      "({:.3f}): two methods differ significantly (α = 0.05) if their bars do not overlap.",
      side.datasets.size(), difference);
  plot.x_label = "average rank";
  plot.marks = Marks::ranges;
  const std::vector<double> ranks = average_ranks(side.costs);
  for (std::size_t m = 0; m < ranks.size(); ++m) {
    plot.series.push_back({side.methods[m]->name,
                           colour_of_method(runs, *side.methods[m]),
                           {ranks[m]},
                           {},
                           {ranks[m] - 0.5 * difference, ranks[m] + 0.5 * difference}});
  }
  std::stable_sort(plot.series.begin(), plot.series.end(),
                   [](const Series& a, const Series& b) { return a.x.front() < b.x.front(); });
  return plot;
}

}  // namespace

std::vector<Plot> survey_plots(const RunGrid& runs) {
  std::vector<Plot> plots;
  if (surveyed(runs).empty()) return plots;
  const Criterion& worst = quality_criterion("radius-ratio-min");
  const Criterion& seconds = quality_criterion("seconds-per-1000-vertices");
  plots.push_back(cumulative_plot(runs, worst, 0.0, 1.0));
  for (const Criterion& criterion : quality_criteria()) plots.push_back(box_plot_of_methods(runs, criterion));
  if (families_of(runs).size() > 1) {
    plots.push_back(box_plot_of_families(runs, worst));
    plots.push_back(box_plot_of_families(runs, seconds));
  }
  plots.push_back(cumulative_plot(runs, quality_criterion("angle-min"), 0.0, 60.0));
  plots.push_back(cumulative_plot(runs, quality_criterion("angle-max"), 60.0, 180.0));
  for (const Criterion* criterion : {&worst, &seconds}) {
    if (side_by_side(runs, *criterion).empty()) continue;
    plots.push_back(profile_plot(runs, *criterion));
    plots.push_back(rank_plot(runs, *criterion));
  }
  plots.push_back(pareto_plot(runs, worst));
  plots.back().y_high = 1.0;
  plots.push_back(pareto_plot(runs, quality_criterion("radius-ratio-avg")));
  std::erase_if(plots, [](const Plot& plot) { return plot.empty(); });
  return plots;
}

}  // namespace isobench
