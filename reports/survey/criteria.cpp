#include "isobench/reports/survey/criteria.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "isobench/reports/record/figure_values.h"

namespace isobench {

namespace {

// A figure of the metrics or a cost. Its declaration says the unit and which value is better.
Criterion declared(const std::string& id, const std::string& name, const std::string& figure, const Print& print,
                   bool timed = false) {
  const FigureDeclaration& declaration = figure_declaration(figure);
  return {id, name, declaration.unit, declaration.better == Better::larger, print, figure_of(figure), timed};
}

Criterion smaller_is_better(const std::string& id, const std::string& name, Figure value, const Print& print) {
  return {id, name, "", false, print, std::move(value), false};
}

Figure distance_between(const std::string& figure, const std::string& reference) {
  return [a = figure_of(figure), b = figure_of(reference)](const RunRecord& run) { return std::abs(a(run) - b(run)); };
}

Figure sum_of(const std::vector<std::string>& names) {
  std::vector<Figure> figures;
  for (const std::string& name : names) figures.emplace_back(figure_of(name));
  return [figures](const RunRecord& run) {
    double sum = 0.0;
    for (const Figure& figure : figures) sum += figure(run);
    return sum;
  };
}

Criterion seconds_per_thousand_vertices() {
  Criterion criterion;
  criterion.id = "seconds-per-1000-vertices";
  criterion.name = "Seconds per 1,000 vertices";
  criterion.larger = false;
  criterion.print = to_significant(3);
  criterion.value = [seconds = figure_of("seconds_total"), vertices = figure_of("vertices")](const RunRecord& run) {
    return 1e3 * seconds(run) / vertices(run);
  };
  criterion.timed = true;
  return criterion;
}

}  // namespace

std::string name_with_unit(const Criterion& criterion) {
  return criterion.unit.empty() ? criterion.name : criterion.name + ", " + criterion.unit;
}

const std::vector<Criterion>& quality_criteria() {
  static const std::vector<Criterion> all = {
      declared("radius-ratio-min", "Smallest radius ratio", "radius_ratio_min", to_significant(3)),
      declared("radius-ratio-avg", "Average radius ratio", "radius_ratio_avg", to_places(4)),
      declared("angle-min", "Smallest angle", "angle_min", to_places(1)),
      declared("angle-max", "Largest angle", "angle_max", to_places(1)), seconds_per_thousand_vertices()};
  return all;
}

const Criterion& quality_criterion(const std::string& id) {
  const auto found = std::find_if(quality_criteria().begin(), quality_criteria().end(),
                                  [&id](const Criterion& each) { return each.id == id; });
  if (found == quality_criteria().end()) throw std::logic_error("no criterion is called '" + id + "'");
  return *found;
}

const std::vector<Criterion>& defect_criteria() {
  static const std::vector<Criterion> all = {
      declared("valence", "Vertices with a valence outside 5–7", "valence_extreme_count", as_number()),
      declared("edge-over-h0", "Longest edge / h0", "edge_over_h0_max", to_significant(4)),
      smaller_is_better("euler", "χ differs from that of F = c by", distance_between("euler", "euler_reference"),
                        as_number()),
      smaller_is_better("components", "Components differ from those of F = c by",
                        distance_between("components", "components_reference"), as_number()),
      smaller_is_better("open", "Boundary edges and pinches",
                        sum_of({"boundary_edges", "nonmanifold_edges", "nonmanifold_vertices"}), as_number()),
      declared("self-intersections", "Self-intersections", "self_intersections", as_number()),
      declared("seconds", "Seconds", "seconds_total", to_significant(3), true),
      declared("memory", "Peak memory", "peak_memory_mb", to_significant(3))};
  return all;
}

}  // namespace isobench
