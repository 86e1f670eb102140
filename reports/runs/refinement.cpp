#include "isobench/reports/runs/refinement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "isobench/reports/record/figure_values.h"

namespace isobench {

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

double median_of_level(const Runs& runs, const Figure& figure) {
  std::vector<double> values;
  for (const RunRecord* run : counted_runs(runs)) values.push_back(figure(*run));
  return spread_of(std::move(values)).median;
}

bool same_sizing(const RunRecord& a, const RunRecord& b) {
  return sizing_name(a.request.sizing) == sizing_name(b.request.sizing);
}

void add_to_level(const RunRecord& run, std::vector<Runs>& levels) {
  auto level =
      std::find_if(levels.begin(), levels.end(), [&run](const Runs& runs) { return same_sizing(*runs.front(), run); });
  if (level == levels.end()) level = levels.insert(level, Runs{});
  level->push_back(&run);
}

// A level without a mesh has fewer vertices than any other.
double number_of_vertices(const Runs& runs) {
  const double vertices = median_of_level(runs, figure_of("vertices"));
  return std::isfinite(vertices) ? vertices : 0.0;
}

struct Point {
  double log_h = 0.0;
  double log_error = 0.0;
};

double slope(const std::vector<Point>& points) {
  const auto n = static_cast<double>(points.size());
  Point mean;
  for (const Point& point : points) {
    mean.log_h += point.log_h / n;
    mean.log_error += point.log_error / n;
  }
  double product = 0.0;
  double square = 0.0;
  for (const Point& point : points) {
    product += (point.log_h - mean.log_h) * (point.log_error - mean.log_error);
    square += (point.log_h - mean.log_h) * (point.log_h - mean.log_h);
  }
  return product / square;
}

}  // namespace

std::vector<Refinement> refinements(const Results& results) {
  std::vector<Refinement> all;
  std::map<std::pair<std::string, std::string>, std::size_t> place;  // of a data set and label in `all`
  for (const RunRecord& run : results.records) {
    const RunRequest& request = run.request;
    if (request.aside) continue;
    const auto [known, fresh] = place.try_emplace({request.dataset, request.label}, all.size());
    if (fresh) all.push_back({request.dataset, request.label, {}});
    add_to_level(run, all[known->second].levels);
  }
  for (Refinement& refinement : all) {
    std::stable_sort(refinement.levels.begin(), refinement.levels.end(),
                     [](const Runs& a, const Runs& b) { return number_of_vertices(a) < number_of_vertices(b); });
  }
  return all;
}

RunGrid finest_runs(const RunGrid& runs) {
  RunGrid finest = runs;
  finest.variants.clear();
  for (const Variant& variant : runs.variants) {
    for (const auto& [dataset, here] : variant.runs) {
      const std::string& label = here.front()->request.label;
      auto of_label = std::find_if(finest.variants.begin(), finest.variants.end(),
                                   [&label](const Variant& known) { return known.name == label; });
      if (of_label == finest.variants.end())
        of_label = finest.variants.insert(of_label, Variant{label, variant.method, {}});
      Runs& kept = of_label->runs[dataset];
      if (kept.empty() || number_of_vertices(here) > number_of_vertices(kept)) kept = here;
    }
  }
  return finest;
}

double mean_edge_length(const RunRecord& run) {
  if (!run.measurement) return no_number;
  const Measurement& m = *run.measurement;
  return std::sqrt(4.0 / std::numbers::sqrt3 * m.number("area") / m.number("triangles"));
}

double solving_seconds(const RunRecord& run) {
  double factors = 0.0;
  double solving = no_number;
  for (const StageTime& stage : run.stages) {
    if (stage.name == "measure/poisson/solve") solving = stage.wall_seconds;
    // Of whichever metric needed them first.
    if (stage.name.starts_with("measure/") && stage.name.ends_with("/factorize")) factors += stage.wall_seconds;
  }
  return factors + solving;
}

Order order_of_convergence(const Refinement& refinement, const Figure& error) {
  constexpr std::size_t fewest_levels = 3;
  constexpr double smallest_ratio = 1.5;
  if (refinement.levels.size() < fewest_levels) return {no_number, "fewer than 3 sizings"};
  std::vector<Point> points;
  for (const Runs& level : refinement.levels) {
    const Point point = {std::log(median_of_level(level, mean_edge_length)), std::log(median_of_level(level, error))};
    if (std::isfinite(point.log_h) && std::isfinite(point.log_error)) points.push_back(point);
  }
  if (points.size() < fewest_levels) return {no_number, "measured at fewer than 3 sizings"};
  const auto [finest, coarsest] = std::minmax_element(points.begin(), points.end(),
                                                      [](const Point& a, const Point& b) { return a.log_h < b.log_h; });
  if (coarsest->log_h - finest->log_h < std::log(smallest_ratio)) return {no_number, "its meshes do not get finer"};
  return {slope(points), ""};
}

}  // namespace isobench
