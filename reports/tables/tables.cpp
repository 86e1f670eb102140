#include "isobench/reports/tables/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "isobench/reports/runs/timing.h"
#include "isobench/reports/tables/sizing_grid.h"
#include "isobench/reports/tables/table_parts.h"

namespace isobench {

namespace {

struct Column {
  std::string title;
  Figure figure;
  Print print;
  bool timed = false;  ///< seconds, which compare only where they were measured alike
};

// A table of one row a dataset and variant; several seeds or repeats give the median and the range, of those that
// counted_runs() lets pass or of all that finished.
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

// A figure of the topology, all of which are whole numbers.
template <class Whole>
Column counted(const std::string& title, Whole&& figure) {
  return {title, [figure](const RunRecord& r) { return static_cast<double>(figure(*r.measurement)); }, as_number()};
}

// What the runs of one seed came to.
std::string sameness(const Runs& runs) {
  const std::size_t meshes = different_meshes(runs);
  if (meshes == 0) return "–";
  return meshes == 1 ? "the same mesh" : fmt::format("{} different meshes", meshes);
}

}  // namespace

Table topology_table(const RunGrid& runs) {
  using M = Measurement;
  Table table = table_of_runs(
      runs, "Topology",
      {counted("components", [](const M& m) { return m.topology.components; }),
       counted("reference", [](const M& m) { return m.reference.components; }),
       counted("χ", [](const M& m) { return m.topology.euler; }),
       counted("reference", [](const M& m) { return m.reference.euler; }),
       counted("k", [](const M& m) { return m.reference.k; }),
       counted("boundary edges", [](const M& m) { return m.topology.boundary_edges; }),
       counted("pinches", [](const M& m) { return m.topology.nonmanifold_edges + m.topology.nonmanifold_vertices; }),
       counted("misoriented edges", [](const M& m) { return m.topology.misoriented_edges; }),
       counted("self-intersections", [](const M& m) { return m.topology.self_intersections; })},
      false);
  table.remarks = {"Pinches are non-manifold edges and vertices together."};
  table.definitions = {"components",        "components_reference", "euler",
                       "euler_reference",   "reference_k",          "boundary_edges",
                       "nonmanifold_edges", "nonmanifold_vertices", "misoriented_edges",
                       "self_intersections"};
  return table;
}

Table distance_table(const RunGrid& runs) {
  using R = RunRecord;
  Table table = table_of_runs(
      runs, "Distance to the surface F = c",
      {{"mean mm", [](const R& r) { return r.measurement->distance.mean; }, to_significant(3)},
       {"max mm", [](const R& r) { return r.measurement->distance.max; }, to_significant(3)},
       {"mean voxels", [](const R& r) { return r.measurement->distance.mean_voxels; }, to_significant(3)},
       {"max voxels", [](const R& r) { return r.measurement->distance.max_voxels; }, to_significant(3)},
       {"vertices max mm", [](const R& r) { return r.measurement->distance.vertex_max; }, to_significant(3)},
       {"from F = c mean mm", [](const R& r) { return r.measurement->distance_from_surface.mean; }, to_significant(3)},
       {"from F = c max mm", [](const R& r) { return r.measurement->distance_from_surface.max; }, to_significant(3)},
       counted("not projected", [](const Measurement& m) { return m.distance.unprojected; })});
  table.definitions = {"distance_mean", "distance_max", "distance_vertex_max", "distance_from_surface_mean",
                       "distance_from_surface_max"};
  return table;
}

Table cost_table(const RunGrid& runs) {
  using R = RunRecord;
  Table table =
      table_of_runs(runs, "Cost",
                    {{"prepare s", [](const R& r) { return r.seconds_prepare; }, to_significant(3), true},
                     {"sizing s", [](const R& r) { return r.seconds_sizing; }, to_significant(3), true},
                     {"method s", [](const R& r) { return r.seconds_method; }, to_significant(3), true},
                     {"sizing + method s", [](const R& r) { return r.seconds_total; }, to_significant(3), true},
                     {"peak MB", [](const R& r) { return r.peak_memory_mb; }, to_significant(3)}});
  table.remarks = {
      "Wall seconds. Prepare reads and prepares the volume; a method that asks for no sizing field pays none; metrics "
      "and files are not counted. Peak memory is the process's, up to the finished mesh."};
  say_how_timed(runs, table);
  return table;
}

Table seed_table(const RunGrid& runs) {
  using R = RunRecord;
  const auto vertices = [](const R& r) { return static_cast<double>(r.measurement->vertices); };
  const auto smallest = [](const R& r) { return r.measurement->radius_ratio.min; };
  const auto average = [](const R& r) { return r.measurement->radius_ratio.avg; };
  const auto six = [](const R& r) { return r.measurement->valence.v6_percent; };
  const auto seconds = [](const R& r) { return r.seconds_total; };
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
  std::vector<Table> tables = ablation_tables(runs);
  for (Table& table :
       std::vector<Table>{sizes_table(results, runs), radius_ratio_table(results, runs), valence_table(results, runs),
                          edge_length_table(results, runs), topology_table(runs), distance_table(runs),
                          cost_table(runs), seed_table(runs), match_table(results)}) {
    tables.push_back(std::move(table));
  }
  for (Table& stages : stage_tables(runs)) tables.push_back(std::move(stages));
  for (Table& grid : sizing_grid_tables(results)) tables.push_back(std::move(grid));
  std::erase_if(tables, [](const Table& table) { return table.empty(); });
  return tables;
}

}  // namespace isobench
