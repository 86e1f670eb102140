// Tables 1 to 3 and Figure 4 of Meyer, Kirby, Whitaker 2007, with the published figures beside ours.
#include <fmt/format.h>

#include <array>

#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/tables/table_parts.h"
#include "isobench/reports/tables/tables.h"

namespace isobench {

namespace {

std::string volume_size(const RunRecord& record) {
  if (!record.dataset) return "–";
  const auto& size = record.dataset->lattice.size;
  return fmt::format("{} × {} × {}", size[0], size[1], size[2]);
}

std::string sizing_cell(const RunRecord& record) {
  const SizingRequest& sizing = record.request.sizing;
  if (sizing.edge_length) return fmt::format("{} mm", *sizing.edge_length);
  if (sizing.vertices) return fmt::format("{} vertices", *sizing.vertices);
  return fmt::format("{}, {}", sizing.epsilon.value_or(0.0), sizing.delta.value_or(0.0));
}

// ε and δ share one cell, so their published values do, too.
TableCell with_published_sizing(TableCell cell, const Results& results, const Variant& variant,
                                const std::string& dataset) {
  cell = with_published(std::move(cell), results, {"epsilon", "delta"}, dataset, variant.method);
  if (cell.published.size() == 2) cell.published = {cell.published[0] + ", " + cell.published[1]};
  return cell;
}

TableRow sizes_row(const Results& results, const RunGrid& arrangement, const Variant& variant,
                   const std::string& dataset, const Runs& runs) {
  const RunRecord& record = *find_run(variant, dataset);
  const auto beside_published = [&](TableCell cell, const char* quantity) {
    return with_published(std::move(cell), results, {quantity}, dataset, variant.method);
  };
  TableRow row = {dataset, variant.name + spread_label(runs), beside_published(volume_size(record), "volume_size"),
                  with_published_sizing(sizing_cell(record), results, variant, dataset)};
  if (record.status != Status::ok) {
    row.insert(row.end(), {instead_of_figures(&record), "–", "–"});
    return row;
  }
  row.push_back(beside_published(
      with_unit(over_timed(arrangement, runs, figure_of("seconds_total"), to_significant(3)), "s"), "minutes"));
  row.push_back(beside_published(over(runs, vertices, as_number()), "vertices"));
  row.push_back(beside_published(with_mark(over(runs, figure_of("triangles"), as_number()), marks(runs)), "triangles"));
  return row;
}

TableCell ratio_cell(const Results& results, const Variant& variant, const std::string& dataset) {
  const RunRecord* record = find_run(variant, dataset);
  TableCell cell = instead_of_figures(record);
  if (record != nullptr && record->status == Status::ok) {
    const Runs& runs = find_runs(variant, dataset);
    cell = beside(over(runs, figure_of("radius_ratio_min"), to_significant(3)),
                  over(runs, figure_of("radius_ratio_avg"), to_places(3)));
    cell.mark = spread_label(runs) + marks(runs);
  }
  return with_published(std::move(cell), results, {"radius_ratio_min", "radius_ratio_avg"}, dataset, variant.method);
}

struct ValenceClass {
  const char* figure;
  Print print;
};
const std::array<ValenceClass, 5>& valence_classes() {
  static const std::array<ValenceClass, 5> classes = {{{"valence_lt5_percent", to_significant(3)},
                                                       {"valence_5_percent", to_places(2)},
                                                       {"valence_6_percent", to_places(2)},
                                                       {"valence_7_percent", to_places(2)},
                                                       {"valence_gt7_percent", to_significant(3)}}};
  return classes;
}

// The paper prints means over its four data sets only for valence 6 and for all valences outside 5 to 7.
void add_published_average(const Results& results, const std::string& method, const std::string& name, Table& table) {
  if (!results.published) return;
  const PublishedFigure* six = results.published->find("valence_6_percent", "average", method);
  const PublishedFigure* extreme = results.published->find("valence_extreme_percent", "average", method);
  if (six == nullptr || extreme == nullptr) return;
  table.rows.push_back(
      {"average", name, "–", "–", six->printed, "–", "below 5 and above 7 together: " + extreme->printed});
}

// Sums of the percentages, for the average of a method over its data sets.
struct ValenceSum {
  std::array<double, 5> shares{};
  int count = 0;

  void add(const TableRow& row) {
    for (std::size_t i = 0; i < shares.size(); ++i) shares[i] += row[i + 2].figures.front().spread.median;
    ++count;
  }
};

TableRow valence_row(const std::string& dataset, const Variant& variant) {
  const Runs& runs = find_runs(variant, dataset);
  TableRow row = {dataset, variant.name + spread_label(runs) + marks(runs)};
  for (const ValenceClass& valence : valence_classes()) {
    row.push_back(over(runs, figure_of(valence.figure), valence.print));
  }
  return row;
}

// The average over the closed manifolds. If no mesh is one, the average over all meshes, marked †.
void add_average(const Variant& variant, const ValenceSum& closed, const ValenceSum& open, Table& table) {
  const ValenceSum& sum = closed.count > 0 ? closed : open;
  const int left_out = closed.count > 0 ? open.count : 0;
  if (sum.count + left_out < 2) return;
  const std::string gate = left_out > 0 ? fmt::format(", {} † left out", left_out) : "";
  TableRow row = {fmt::format("average of {}{}", sum.count, gate), variant.name + (closed.count > 0 ? "" : " †")};
  for (std::size_t i = 0; i < sum.shares.size(); ++i) {
    const double mean = sum.shares[i] / sum.count;
    row.emplace_back().figures.push_back({{mean, mean, mean}, valence_classes()[i].print});
  }
  table.rows.push_back(std::move(row));
}

void add_valences(const Results& results, const RunGrid& runs, const Variant& variant, Table& table) {
  ValenceSum closed;
  ValenceSum open;
  for (const std::string& dataset : runs.datasets) {
    const RunRecord* record = find_run(variant, dataset);
    if (record == nullptr) continue;
    if (record->status != Status::ok) {
      table.rows.push_back({dataset, variant.name, instead_of_figures(record), "–", "–", "–", "–"});
      continue;
    }
    table.rows.push_back(valence_row(dataset, variant));
    const bool whole = is_closed_manifold(*counted_runs(find_runs(variant, dataset)).front());
    (whole ? closed : open).add(table.rows.back());
  }
  add_average(variant, closed, open, table);
  const PublishedMethod* printed = results.published ? results.published->method_beside(variant.method) : nullptr;
  if (printed != nullptr) add_published_average(results, variant.method, "published: " + printed->printed, table);
}

TableRow edge_row(const Results& results, const Variant& variant, const std::string& dataset, const Runs& runs) {
  const auto published = [&](TableCell cell) {
    return with_published(std::move(cell), results, {"edge_over_own_h0_exceed_triangle_percent"}, dataset,
                          variant.method);
  };
  const RunRecord* record = find_run(variant, dataset);
  if (record->status != Status::ok) {
    return {dataset, variant.name + spread_label(runs), instead_of_figures(record), "–", "–", "–", published("–"), "–"};
  }
  const auto exceed_count = figure_of("edge_over_h0_exceed_count");
  return {dataset,
          variant.name + spread_label(runs) + marks(runs),
          over(runs, figure_of("edge_over_h0_max"), to_significant(4)),
          over(runs, exceed_count, as_number()),
          over(runs, figure_of("edge_over_h0_exceed_percent"), to_significant(3)),
          over(runs, figure_of("edge_over_h0_exceed_triangle_percent"), to_significant(3)),
          published(over(runs, figure_of("edge_over_own_h0_exceed_triangle_percent"), to_significant(3))),
          over(runs, figure_of("floor_area_percent"), to_significant(3))};
}

}  // namespace

Table sizes_table(const Results& results, const RunGrid& runs) {
  Table table;
  table.title = "Table 1: the data sets and their meshes";
  table.header = {"Data", "Method", "Volume size", "ε, δ or size", "Time", "Vertices", "Triangles"};
  for (const std::string& dataset : runs.datasets) {
    for (const Variant& variant : runs.variants) {
      const Runs& group = find_runs(variant, dataset);
      if (!group.empty()) table.rows.push_back(sizes_row(results, runs, variant, dataset, group));
    }
  }
  table.remarks = {"Time covers sizing and method, from the prepared volume in memory to the finished mesh."};
  say_how_timed(runs, table);
  table.source = source_line(results, "Table 1");
  return table;
}

Table radius_ratio_table(const Results& results, const RunGrid& runs) {
  Table table;
  table.title = "Table 2: radius ratios, smallest / average";
  table.header = {"min / avg"};
  table.header.insert(table.header.end(), runs.datasets.begin(), runs.datasets.end());
  table.label_columns = 1;
  for (const Variant& variant : runs.variants) {
    TableRow row = {variant.name};
    for (const std::string& dataset : runs.datasets) row.push_back(ratio_cell(results, variant, dataset));
    table.rows.push_back(std::move(row));
  }
  if (table.empty()) return table;
  for (const PublishedMethod* method : published_alone(results, runs, "Table 2")) {
    TableRow row = {method->name + " (published: " + method->printed + ")"};
    for (const std::string& dataset : runs.datasets) {
      const TableCell cell =
          with_published({}, results, {"radius_ratio_min", "radius_ratio_avg"}, dataset, method->name);
      row.push_back(cell.published.empty() ? TableCell("–") : cell);
    }
    table.rows.push_back(std::move(row));
  }
  table.definitions = {"radius_ratio_min", "radius_ratio_avg"};
  table.source = source_line(results, "Table 2");
  return table;
}

Table valence_table(const Results& results, const RunGrid& runs) {
  Table table;
  table.title = "Table 3: vertex valences, percent of the vertices";
  table.header = {"Data", "Method", "< 5 %", "5 %", "6 %", "7 %", "> 7 %"};
  for (const Variant& variant : runs.variants) add_valences(results, runs, variant, table);
  if (table.empty()) return table;
  for (const PublishedMethod* method : published_alone(results, runs, "Table 3")) {
    add_published_average(results, method->name, method->name + " (published: " + method->printed + ")", table);
  }
  table.definitions = {"valence_lt5_percent", "valence_6_percent", "valence_gt7_percent"};
  table.source = source_line(results, "Table 3");
  return table;
}

Table edge_length_table(const Results& results, const RunGrid& runs) {
  Table table;
  table.title = "Edges above h0 (the paper's Figure 4)";
  table.header = {"Data",       "Method",         "max edge / h0",          "edges above h0",
                  "% of edges", "% of triangles", "% of triangles, own h0", "% of area on the floor"};
  for (const std::string& dataset : runs.datasets) {
    for (const Variant& variant : runs.variants) {
      const Runs& group = find_runs(variant, dataset);
      if (!group.empty()) table.rows.push_back(edge_row(results, variant, dataset, group));
    }
  }
  table.remarks = {
      "h0 is the same for every method. Own h0 belongs to the sizing field that a method computed itself, for example "
      "from another medial axis. The paper compares edges with its own h0."};
  table.definitions = {"edge_over_h0_max", "edge_over_h0_exceed_percent", "edge_over_h0_exceed_triangle_percent",
                       "edge_over_own_h0_exceed_triangle_percent", "floor_area_percent"};
  table.source = source_line(results, "Figure 4");
  return table;
}

}  // namespace isobench
