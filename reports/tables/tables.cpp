#include "isobench/reports/tables/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>

#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/runs/timing.h"
#include "isobench/reports/tables/sizing_grid.h"
#include "isobench/reports/tables/survey_tables.h"
#include "isobench/reports/tables/table_parts.h"

namespace isobench {

namespace {

struct Column {
  std::string title;
  Figure figure;
  Print print;
  bool timed = false;  ///< seconds, which are compared only between runs that were timed alike
};

// A table with one row for each dataset and variant. Several seeds or repeats give the median and the range over
// counted_runs() or, if `gate` is false, over all finished runs.
Table table_of_runs(const RunGrid& runs, const std::string& title, const std::vector<Column>& columns,
                    bool gate = true) {
  Table table;
  table.title = title;
  table.header = {"Data", "Method"};
  for (const Column& column : columns) table.header.push_back(column.title);
  for (const std::string& dataset : runs.datasets) {
    for (const Variant& variant : runs.variants) {
      const Runs& group = find_runs(variant, dataset);
      if (group.empty()) continue;
      const RunRecord* record = find_run(variant, dataset);
      const bool ok = record->status == Status::ok;
      TableRow row = {dataset, variant.name + spread_label(group, gate) + marks(group)};
      for (const Column& column : columns) {
        row.push_back(!ok            ? TableCell("–")
                      : column.timed ? over_timed(runs, group, column.figure, column.print)
                      : gate         ? over(group, column.figure, column.print)
                                     : over_all(group, column.figure, column.print));
      }
      if (!ok) row[2] = instead_of_figures(record);
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

Column counted(const std::string& title, const std::string& figure) { return {title, figure_of(figure), as_number()}; }

double pinches(const RunRecord& run) {
  return run.measurement->number("nonmanifold_edges") + run.measurement->number("nonmanifold_vertices");
}

void append(std::vector<Table> more, std::vector<Table>& tables) {
  std::move(more.begin(), more.end(), std::back_inserter(tables));
}

// Whether the repeats of a seed agree.
std::string sameness(const Runs& runs) {
  const std::size_t meshes = different_meshes(runs);
  if (meshes == 0) return "–";
  return meshes == 1 ? "the same mesh" : fmt::format("{} different meshes", meshes);
}

}  // namespace

Table topology_table(const RunGrid& runs) {
  Table table = table_of_runs(runs, "Topology",
                              {counted("components", "components"),
                               counted("reference", "components_reference"),
                               counted("χ", "euler"),
                               counted("reference", "euler_reference"),
                               counted("boundary edges", "boundary_edges"),
                               {"pinches", pinches, as_number()},
                               counted("misoriented edges", "misoriented_edges"),
                               counted("self-intersections", "self_intersections")},
                              false);
  table.remarks = {"Pinches are non-manifold edges and vertices together."};
  table.definitions = {"components",           "components_reference", "euler",
                       "euler_reference",      "boundary_edges",       "nonmanifold_edges",
                       "nonmanifold_vertices", "misoriented_edges",    "self_intersections"};
  return table;
}

Table distance_table(const RunGrid& runs) {
  Table table = table_of_runs(runs, "Distance to the surface F = c",
                              {{"mean mm", figure_of("distance_mean"), to_significant(3)},
                               {"max mm", figure_of("distance_max"), to_significant(3)},
                               {"mean voxels", figure_of("distance_mean_voxels"), to_significant(3)},
                               {"max voxels", figure_of("distance_max_voxels"), to_significant(3)},
                               {"vertices: max mm", figure_of("distance_vertex_max"), to_significant(3)},
                               {"F = c to mesh: mean mm", figure_of("distance_from_surface_mean"), to_significant(3)},
                               {"F = c to mesh: max mm", figure_of("distance_from_surface_max"), to_significant(3)},
                               counted("not projected", "distance_unprojected")});
  table.definitions = {"distance_mean", "distance_max", "distance_vertex_max", "distance_from_surface_mean",
                       "distance_from_surface_max"};
  return table;
}

Table cost_table(const RunGrid& runs) {
  Table table = table_of_runs(runs, "Cost",
                              {{"prepare s", figure_of("seconds_prepare"), to_significant(3), true},
                               {"sizing s", figure_of("seconds_sizing"), to_significant(3), true},
                               {"method s", figure_of("seconds_method"), to_significant(3), true},
                               {"sizing + method s", figure_of("seconds_total"), to_significant(3), true},
                               {"peak MB", figure_of("peak_memory_mb"), to_significant(3)}});
  table.remarks = {
      "Wall seconds. \"prepare\" is reading and preparing the volume. \"sizing\" is 0 s if the method asks for no "
      "sizing field. Metrics and files are not counted. Peak memory counts the process up to the finished mesh."};
  say_how_timed(runs, table);
  return table;
}

Table seed_table(const RunGrid& runs) {
  const auto vertices = figure_of("vertices");
  const auto smallest = figure_of("radius_ratio_min");
  const auto average = figure_of("radius_ratio_avg");
  const auto six = figure_of("valence_6_percent");
  const auto seconds = figure_of("seconds_total");
  Table table;
  table.title = "Spread over seeds and repeats: median (smallest–largest)";
  table.header = {"Data",        "Method",  "vertices",           "radius ratio min", "radius ratio avg",
                  "valence 6 %", "seconds", "repeats of one seed"};
  for (const std::string& dataset : runs.datasets) {
    for (const Variant& variant : runs.variants) {
      const Runs group = finished(find_runs(variant, dataset));
      if (group.size() < 2) continue;
      table.rows.push_back({dataset, variant.name + spread_label(find_runs(variant, dataset)) + marks(group),
                            over(group, vertices, as_number()), over(group, smallest, to_significant(3)),
                            over(group, average, to_significant(4)), over(group, six, to_significant(4)),
                            over_timed(runs, group, seconds, to_significant(3)), sameness(group)});
    }
  }
  say_how_timed(runs, table);
  return table;
}

std::vector<Table> all_tables(const Results& results) {
  const RunGrid runs = arrange_runs(results);
  const bool many = has_many_datasets(runs);
  std::vector<Table> tables = many ? survey_tables(runs) : std::vector<Table>();
  append(use_tables(results, runs), tables);
  const std::size_t overview = tables.size();
  append(ablation_tables(runs), tables);
  append({sizes_table(results, runs), many ? dataset_table(runs) : radius_ratio_table(results, runs),
          valence_table(results, runs), edge_length_table(results, runs), topology_table(runs), distance_table(runs),
          cost_table(runs), seed_table(runs), match_table(results)},
         tables);
  append(stage_tables(runs), tables);
  for (std::size_t n = overview; n < tables.size(); ++n) tables[n].detail = many;
  append(sizing_grid_tables(results), tables);
  std::erase_if(tables, [](const Table& table) { return table.empty(); });
  return tables;
}

}  // namespace isobench
