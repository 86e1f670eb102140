#include "isobench/reports/tables/sizing_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/tables/table_parts.h"

namespace isobench {

namespace {

void remember(std::vector<double>& values, double value) {
  if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
}

const Runs& cell(const SizingGrid& grid, double epsilon, double delta) {
  static const Runs none;
  const auto found = grid.cells.find({epsilon, delta});
  return found == grid.cells.end() ? none : found->second;
}

double median(const Runs& runs, const Figure& figure) {
  std::vector<double> values;
  for (const RunRecord* run : counted_runs(runs)) values.push_back(figure(*run));
  return spread_of(std::move(values)).median;
}

void count(double before, double after, Trend& trend) {
  if (!std::isfinite(before) || !std::isfinite(after)) return;
  ++trend.steps;
  if (after > before) ++trend.rises;
  if (after < before) ++trend.falls;
}

struct Row {
  const char* title;
  Figure figure;
  Print print;
};

const std::vector<Row>& rows() {
  static const std::vector<Row> all = {{"triangles", figure_of("triangles"), as_number()},
                                       {"radius ratio min", figure_of("radius_ratio_min"), to_significant(3)},
                                       {"radius ratio avg", figure_of("radius_ratio_avg"), to_places(3)},
                                       {"mean distance mm", figure_of("distance_mean"), to_significant(3)}};
  return all;
}

TableCell cell_of(const Runs& runs, const Row& row, bool first) {
  if (runs.empty()) return "not run";
  if (finished(runs).empty()) return first ? instead_of_figures(runs.front()) : "–";
  return with_mark(over(runs, row.figure, row.print), first ? marks(runs) : "");
}

Table table_of(const SizingGrid& grid) {
  Table table;
  table.header = {"ε", "Figure"};
  for (const double delta : grid.deltas) table.header.push_back(fmt::format("δ {}", delta));
  for (const double epsilon : grid.epsilons) {
    for (const Row& row : rows()) {
      const bool first = &row == &rows().front();
      TableRow cells = {first ? fmt::format("{}", epsilon) : "", row.title};
      for (const double delta : grid.deltas) cells.push_back(cell_of(cell(grid, epsilon, delta), row, first));
      table.rows.push_back(std::move(cells));
    }
  }
  return table;
}

std::string trend_text(const SizingGrid& grid) {
  const auto of = [&grid](Along along, std::size_t row) { return trend(grid, along, rows()[row].figure); };
  const auto rise = [](const char* what, const Trend& t) { return fmt::format("{} rises in {}", what, t.rises); };
  const auto fall = [](const char* what, const Trend& t) { return fmt::format("{} falls in {}", what, t.falls); };
  return fmt::format("Of {} steps to the next smaller ε: {}, {}. Of {} steps to the next smaller δ: {}, {}, {}.",
                     of(Along::epsilon, 0).steps, fall("the mean distance", of(Along::epsilon, 3)),
                     rise("the number of triangles", of(Along::epsilon, 0)), of(Along::delta, 0).steps,
                     rise("the smallest radius ratio", of(Along::delta, 1)),
                     rise("the average radius ratio", of(Along::delta, 2)),
                     rise("the number of triangles", of(Along::delta, 0)));
}

}  // namespace

std::vector<SizingGrid> sizing_grids(const Results& results) {
  std::vector<SizingGrid> grids;
  for (const RunRecord& record : results.records) {
    const RunRequest& request = record.request;
    if (!request.sizing.epsilon || !request.sizing.delta) continue;
    auto grid = std::find_if(grids.begin(), grids.end(), [&request](const SizingGrid& candidate) {
      return candidate.dataset == request.dataset && candidate.label == request.label;
    });
    if (grid == grids.end()) grid = grids.insert(grid, SizingGrid{request.dataset, request.label, {}, {}, {}});
    remember(grid->epsilons, *request.sizing.epsilon);
    remember(grid->deltas, *request.sizing.delta);
    Runs& runs = grid->cells[{*request.sizing.epsilon, *request.sizing.delta}];
    const bool alike = runs.empty() || runs.front()->request.sizing.floor == request.sizing.floor;
    if (alike) runs.push_back(&record);
  }
  std::erase_if(grids, [](const SizingGrid& grid) {
    const std::size_t rows = grid.epsilons.size();
    const std::size_t columns = grid.deltas.size();
    return rows < 2 || columns < 2 || grid.cells.size() < rows + columns;
  });
  return grids;
}

Trend trend(const SizingGrid& grid, Along along, const Figure& figure) {
  std::vector<double> epsilons = grid.epsilons;
  std::vector<double> deltas = grid.deltas;
  std::sort(epsilons.rbegin(), epsilons.rend());
  std::sort(deltas.rbegin(), deltas.rend());
  const bool down = along == Along::epsilon;
  Trend result;
  for (std::size_t e = 0; e < epsilons.size(); ++e) {
    for (std::size_t d = 0; d < deltas.size(); ++d) {
      if ((down ? e : d) == 0) continue;
      const Runs& before = cell(grid, epsilons[down ? e - 1 : e], deltas[down ? d : d - 1]);
      count(median(before, figure), median(cell(grid, epsilons[e], deltas[d]), figure), result);
    }
  }
  return result;
}

std::vector<Table> sizing_grid_tables(const Results& results) {
  std::vector<Table> tables;
  for (const SizingGrid& grid : sizing_grids(results)) {
    // Every cell has the same seeds and repeats, but not the same failures.
    const Runs& first = grid.cells.begin()->second;
    Table table = table_of(grid);
    table.title = fmt::format("Grid of ε (rows) and δ (columns), as in the paper's Figure 2: {}, {}{}", grid.dataset,
                              grid.label, spread_label(finished(first)));
    table.remarks = {trend_text(grid)};
    table.definitions = {"triangles", "radius_ratio_min", "radius_ratio_avg", "distance_mean"};
    tables.push_back(std::move(table));
  }
  return tables;
}

}  // namespace isobench
