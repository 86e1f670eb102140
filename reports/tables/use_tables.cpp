// What a mesh costs a simulation and what the simulation gets from it: one line a method.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/runs/refinement.h"
#include "isobench/reports/runs/timing.h"
#include "isobench/reports/tables/table_parts.h"
#include "isobench/reports/tables/tables.h"

namespace isobench {

namespace {

// Explicit steps of the heat equation until t = L²/4, with L² the area over 4π: t over the largest step
// 2h²/step_factor. With an adaptive sizing step_factor does not say how long the step is.
double explicit_steps(const RunRecord& run) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (!run.measurement || !run.sizing || !run.sizing->uniform) return none;
  const double h = mean_edge_length(run);
  const double time = run.measurement->number("area") / (16.0 * std::numbers::pi);
  return std::ceil(time * run.measurement->number("step_factor") / (2.0 * h * h));
}

struct UseColumn {
  std::string title;
  Figure figure;
  Print print;
  bool timed = false;
};

// All of them are better if smaller.
std::vector<UseColumn> use_columns() {
  return {{"negative weights", figure_of("negative_weights"), as_number()},
          {"obtuse %", figure_of("obtuse_percent"), to_significant(3)},
          {"step factor", figure_of("step_factor"), to_significant(3)},
          {"steps", explicit_steps, to_significant(3)},
          {"condition", figure_of("condition"), to_significant(3)},
          {"CG iterations", figure_of("cg_iterations"), as_number()},
          {"Poisson max", figure_of("poisson_max"), to_significant(3)},
          {"Poisson L2", figure_of("poisson_l2"), to_significant(3)},
          {"gradient max", figure_of("gradient_max"), to_significant(3)},
          {"normal max °", figure_of("normal_angle_max"), to_significant(3)},
          {"curvature max", figure_of("curvature_max"), to_significant(3)},
          {"meshing s", figure_of("seconds_total"), to_significant(3), true}};
}

struct OrderColumn {
  std::string title;
  std::string figure;
};
const std::vector<OrderColumn>& order_columns() {
  static const std::vector<OrderColumn> all = {{"order, Poisson max", "poisson_max"},
                                               {"order, Poisson L2", "poisson_l2"},
                                               {"order, gradient max", "gradient_max"}};
  return all;
}

// One method: its finest runs on the data sets of the table.
struct UseRow {
  std::string label;
  Runs runs;
  std::vector<const Refinement*> refinements;
};

bool measures_use(const RunRecord& run) {
  return std::any_of(figures_of_use().begin(), figures_of_use().end(),
                     [&run](const std::string& figure) { return std::isfinite(figure_value(run, figure)); });
}

std::vector<UseRow> rows_on(const std::vector<Refinement>& all, const std::vector<std::string>& datasets) {
  std::vector<UseRow> rows;
  for (const Refinement& refinement : all) {
    if (std::find(datasets.begin(), datasets.end(), refinement.dataset) == datasets.end()) continue;
    const std::string& label = refinement.label;
    auto row = std::find_if(rows.begin(), rows.end(), [&label](const UseRow& each) { return each.label == label; });
    if (row == rows.end()) row = rows.insert(row, UseRow{label, {}, {}});
    const Runs& finest = refinement.levels.back();
    row->runs.insert(row->runs.end(), finest.begin(), finest.end());
    row->refinements.push_back(&refinement);
  }
  return rows;
}

std::vector<double> orders_of(const UseRow& row, const std::string& figure) {
  std::vector<double> orders;
  for (const Refinement* refinement : row.refinements)
    orders.push_back(order_of_convergence(*refinement, figure_of(figure)).value);
  std::erase_if(orders, [](double order) { return !std::isfinite(order); });
  return orders;
}

TableCell order_cell(std::vector<double> orders) {
  if (orders.empty()) return "–";
  TableCell cell;
  cell.figures.push_back({spread_of(std::move(orders)), to_places(2)});
  return cell;
}

TableRow table_row(const RunGrid& arrangement, const UseRow& row, bool with_orders) {
  const bool ok = !finished(row.runs).empty();
  TableRow cells = {row.label + spread_label(row.runs) + marks(row.runs)};
  cells.push_back(ok ? over(row.runs, vertices, as_number()) : instead_of_figures(row.runs.front()));
  for (const UseColumn& column : use_columns()) {
    cells.push_back(!ok            ? TableCell("–")
                    : column.timed ? over_timed(arrangement, row.runs, column.figure, column.print)
                                   : over(row.runs, column.figure, column.print));
  }
  if (!with_orders) return cells;
  for (const OrderColumn& column : order_columns()) cells.push_back(order_cell(orders_of(row, column.figure)));
  return cells;
}

// The rows that are compared. Quality at another number of vertices is no comparison.
std::vector<UseRow> matched(const std::vector<UseRow>& rows) {
  std::vector<UseRow> all = rows;
  std::erase_if(all, [](const UseRow& row) {
    return std::any_of(row.runs.begin(), row.runs.end(), [](const RunRecord* run) { return is_unmatched(*run); });
  });
  return all;
}

double median_of_row(const RunGrid& arrangement, const UseRow& row, const UseColumn& column) {
  const Runs counted = counted_runs(row.runs);
  std::vector<double> values;
  for (const RunRecord* run : column.timed ? runs_with_timing(counted, arrangement.timing) : counted)
    values.push_back(column.figure(*run));
  return spread_of(std::move(values)).median;
}

// The rows with the smallest value of a column, as printed. None if more than two have it, which is no news.
std::vector<std::size_t> best_rows(const RunGrid& arrangement, const std::vector<UseRow>& rows,
                                   const UseColumn& column) {
  std::vector<std::size_t> best;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < rows.size(); ++n) {
    const double value = median_of_row(arrangement, rows[n], column);
    if (!std::isfinite(value)) continue;
    const bool equal = column.print(value) == column.print(smallest);
    if (!equal && value > smallest) continue;
    if (!equal) best.clear();
    smallest = std::min(smallest, value);
    best.push_back(n);
  }
  const bool news = best.size() < std::min<std::size_t>(rows.size(), 3);
  return news ? best : std::vector<std::size_t>{};
}

// "Best: particles at condition, Poisson max; cvt at step factor, steps." So a reader sees where each method loses.
std::string best_sentence(const RunGrid& arrangement, const std::vector<UseRow>& all) {
  const std::vector<UseRow> rows = matched(all);
  std::vector<std::vector<std::string>> best_at(rows.size());
  for (const UseColumn& column : use_columns()) {
    for (const std::size_t n : best_rows(arrangement, rows, column)) best_at[n].push_back(column.title);
  }
  std::vector<std::string> parts;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    if (best_at[n].empty()) continue;
    parts.push_back(fmt::format("{} at {}", rows[n].label, fmt::join(best_at[n], ", ")));
  }
  return parts.empty() ? "" : fmt::format("Best: {}.", fmt::join(parts, "; "));
}

Table use_table(const RunGrid& arrangement, const std::vector<UseRow>& rows, const std::string& of) {
  Table table;
  const bool measured = std::any_of(rows.begin(), rows.end(), [](const UseRow& row) {
    return std::any_of(row.runs.begin(), row.runs.end(), [](const RunRecord* run) { return measures_use(*run); });
  });
  if (!measured) return table;
  const bool with_orders = std::any_of(rows.begin(), rows.end(), [](const UseRow& row) {
    return std::any_of(order_columns().begin(), order_columns().end(),
                       [&row](const OrderColumn& column) { return !orders_of(row, column.figure).empty(); });
  });
  table.title = "What a simulation pays and gets: " + of;
  table.label_columns = 1;
  table.header = {"Method", "vertices"};
  for (const UseColumn& column : use_columns()) table.header.push_back(column.title);
  for (const OrderColumn& column : order_columns()) {
    if (with_orders) table.header.push_back(column.title);
  }
  for (const UseRow& row : rows) table.rows.push_back(table_row(arrangement, row, with_orders));
  if (const std::string best = best_sentence(arrangement, rows); !best.empty()) table.remarks.push_back(best);
  return table;
}

// What stands under the last table for all of them.
void explain(const RunGrid& arrangement, Table& table) {
  table.remarks.emplace_back(
      "Smaller is better in every column but the orders. Methods with ‡ have another number of vertices and are not "
      "counted as best. If a method has several sizings, the row shows its finest mesh. \"Steps\" are explicit steps "
      "of the heat equation until the time L²/4, for meshes with edges of one length. An order is the slope of log "
      "error over log h, by least squares over at least three sizings whose h differ by half as much again or more; "
      "2 for Poisson and 1 for the gradient are those of linear elements.");
  say_how_timed(arrangement, table);
  table.definitions = {"negative_weights", "obtuse_percent", "step_factor",  "condition",        "cg_iterations",
                       "poisson_max",      "poisson_l2",     "gradient_max", "normal_angle_max", "curvature_max"};
}

}  // namespace

const std::vector<std::string>& figures_of_use() {
  static const std::vector<std::string> all = {"step_factor", "condition",  "cg_iterations",
                                               "poisson_max", "poisson_l2", "gradient_max"};
  return all;
}

std::vector<Table> use_tables(const Results& results, const RunGrid& runs) {
  const std::vector<Refinement> all = refinements(results);
  std::vector<Table> tables;
  if (has_many_datasets(runs)) {
    tables.push_back(use_table(runs, rows_on(all, runs.datasets), "medians over all data sets"));
  } else {
    for (const std::string& dataset : runs.datasets)
      tables.push_back(use_table(runs, rows_on(all, {dataset}), dataset));
  }
  std::erase_if(tables, [](const Table& table) { return table.empty(); });
  if (!tables.empty()) explain(runs, tables.back());
  return tables;
}

}  // namespace isobench
