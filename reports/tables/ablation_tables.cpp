// The effect of one choice within a method: runs that differ from a base in a single parameter.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/tables/table_parts.h"
#include "isobench/reports/tables/tables.h"

namespace isobench {

namespace {

struct Change {
  const Variant* variant;
  std::string text;  // "limiter = iteration"
};

struct Ablation {
  const Variant* base = nullptr;
  std::vector<Change> changes;
};

// The parameter that differs, if it is the only difference between the two.
std::optional<std::string> only_change(const RunRequest& base, const RunRequest& other) {
  if (base.method != other.method || sizing_name(base.sizing) != sizing_name(other.sizing) ||
      base.match_to != other.match_to) {
    return std::nullopt;
  }
  std::optional<std::string> change;
  for (const auto& [name, value] : *other.parameters) {
    const auto usual = base.parameters->find(name);
    if (usual != base.parameters->end() && usual->second == value) continue;
    if (change) return std::nullopt;
    change = fmt::format("{} = {}", name, to_string(value));
  }
  return change;
}

const RunRequest* any_request(const Variant& variant) {
  return variant.runs.empty() ? nullptr : &variant.runs.begin()->second.front()->request;
}

Ablation changes_from(const RunGrid& runs, const Variant& base) {
  Ablation found;
  found.base = &base;
  const RunRequest* usual = any_request(base);
  for (const Variant& variant : runs.variants) {
    const RunRequest* request = any_request(variant);
    if (usual == nullptr || request == nullptr || &variant == &base) continue;
    if (auto change = only_change(*usual, *request)) found.changes.push_back({&variant, std::move(*change)});
  }
  return found;
}

// For each method, the variant from which the most others differ in one parameter; if several, the first in the plan.
std::vector<Ablation> ablations(const RunGrid& runs) {
  std::vector<Ablation> all;
  for (const Variant& variant : runs.variants) {
    Ablation found = changes_from(runs, variant);
    if (found.changes.size() < 2) continue;
    const auto same = std::find_if(all.begin(), all.end(),
                                   [&](const Ablation& other) { return other.base->method == variant.method; });
    if (same == all.end())
      all.push_back(std::move(found));
    else if (found.changes.size() > same->changes.size())
      *same = std::move(found);
  }
  return all;
}

double defects(const RunRecord& run) {
  double sum = 0.0;
  for (const char* figure : {"boundary_edges", "nonmanifold_edges", "nonmanifold_vertices", "self_intersections"})
    sum += run.measurement->number(figure);
  return sum;
}

struct StageColumn {
  std::string title;
  Figure figure;
  Print print;
  enum class Over { sound_meshes, all_meshes, alike_timed } over = Over::sound_meshes;
};

const std::vector<StageColumn>& columns() {
  using Over = StageColumn::Over;
  static const std::vector<StageColumn> all{
      {"vertices", figure_of("vertices"), as_number()},
      {"Q min", figure_of("radius_ratio_min"), to_places(3)},
      {"Q avg", figure_of("radius_ratio_avg"), to_places(4)},
      {"valence 6 %", figure_of("valence_6_percent"), to_places(1)},
      {"edges > h0 %", figure_of("edge_over_h0_exceed_percent"), to_places(4)},
      {"edges > own h0 %", figure_of("edge_over_own_h0_exceed_percent"), to_places(4)},
      {"χ", figure_of("euler"), as_number(), Over::all_meshes},
      {"defects", defects, as_number(), Over::all_meshes},
      {"seconds", figure_of("seconds_total"), to_significant(3), Over::alike_timed},
  };
  return all;
}

TableCell cell_of(const RunGrid& runs, const Runs& group, const StageColumn& column) {
  if (column.over == StageColumn::Over::alike_timed) return over_timed(runs, group, column.figure, column.print);
  return column.over == StageColumn::Over::all_meshes ? over_all(group, column.figure, column.print)
                                                      : over(group, column.figure, column.print);
}

// " [+0.012]"; "" where it prints as zero.
std::string difference(const TableCell& cell, const TableCell& base) {
  if (cell.figures.empty() || base.figures.empty()) return "";
  const double change = cell.figures[0].spread.median - base.figures[0].spread.median;
  const std::string size = cell.figures[0].print(std::abs(change));
  if (!std::isfinite(change) || size.find_first_not_of("0.") == std::string::npos) return "";
  return fmt::format(" [{}{}]", change < 0.0 ? "−" : "+", size);
}

TableRow row_of(const RunGrid& runs, const std::string& dataset, const std::string& label, const Runs& group,
                const Runs& base) {
  TableRow row = {dataset, label + spread_label(group) + marks(group)};
  for (const StageColumn& column : columns()) {
    if (finished(group).empty()) {
      row.push_back("–");
      continue;
    }
    TableCell cell = cell_of(runs, group, column);
    if (&group != &base && !finished(base).empty()) cell.mark += difference(cell, cell_of(runs, base, column));
    row.push_back(std::move(cell));
  }
  if (finished(group).empty()) row[2] = instead_of_figures(group.front());
  return row;
}

}  // namespace

std::vector<Table> ablation_tables(const RunGrid& runs) {
  std::vector<Table> tables;
  for (const Ablation& ablation : ablations(runs)) {
    Table table;
    table.title = "Effect of changing one parameter: " + ablation.base->name;
    table.header = {"Data", "Changed"};
    for (const StageColumn& column : columns()) table.header.push_back(column.title);
    for (const std::string& dataset : runs.datasets) {
      const Runs& base = find_runs(*ablation.base, dataset);
      if (!base.empty()) table.rows.push_back(row_of(runs, dataset, "nothing", base, base));
      for (const Change& change : ablation.changes) {
        const Runs& group = find_runs(*change.variant, dataset);
        if (!group.empty()) table.rows.push_back(row_of(runs, dataset, change.text, group, base));
      }
    }
    table.remarks = {
        "Square brackets: the median of this row minus the median of the row \"nothing\" of the same data, unless it "
        "rounds to zero. Q is the radius ratio. h0 is the same for every method; own h0 belongs to the sizing field "
        "that the run computed itself. Defects are boundary edges, pinches and self-intersections together. Seconds "
        "are wall seconds of sizing and method."};
    table.definitions = {"radius_ratio_avg", "edge_over_h0_exceed_percent", "edge_over_own_h0_exceed_percent", "euler"};
    tables.push_back(std::move(table));
  }
  return tables;
}

}  // namespace isobench
