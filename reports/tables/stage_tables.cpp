#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "isobench/reports/tables/table_parts.h"
#include "isobench/reports/tables/tables.h"

namespace isobench {

namespace {

// The stage of the whole method with its sizing field. "mesh/relaxation" is one of its parts.
const std::string whole_method = "mesh";

const StageTime* find_stage(const RunRecord& run, const std::string& name) {
  const auto found = std::find_if(run.stages.begin(), run.stages.end(),
                                  [&name](const StageTime& stage) { return stage.name == name; });
  return found == run.stages.end() ? nullptr : &*found;
}

double wall_seconds(const RunRecord& run, const std::string& name) {
  const StageTime* stage = find_stage(run, name);
  return stage == nullptr ? 0.0 : stage->wall_seconds;
}

double parallel(const RunRecord& run) {
  const StageTime* stage = find_stage(run, whole_method);
  return stage == nullptr ? std::numeric_limits<double>::quiet_NaN() : stage->cpu_seconds / stage->wall_seconds;
}

double microseconds_a_vertex(const RunRecord& run) { return 1e6 * wall_seconds(run, whole_method) / vertices(run); }

// The stages of a method's finished runs, without stages within stages, in the order in which they ended.
std::vector<std::string> stages_of(const RunGrid& runs, const std::string& method) {
  std::vector<std::string> names;
  for (const Variant& variant : runs.variants) {
    if (variant.method != method) continue;
    for (const auto& [dataset, group] : variant.runs) {
      for (const RunRecord* run : finished(group)) {
        for (const StageTime& stage : run->stages) {
          const bool part = stage.name.starts_with(whole_method + "/") &&
                            stage.name.find('/', whole_method.size() + 1) == std::string::npos;
          if (part && std::find(names.begin(), names.end(), stage.name) == names.end()) names.push_back(stage.name);
        }
      }
    }
  }
  return names;
}

TableRow stage_row(const RunGrid& runs, const std::string& dataset, const Variant& variant,
                   const std::vector<std::string>& stages) {
  const Runs& group = find_runs(variant, dataset);
  TableRow row = {dataset, variant.name + spread_label(group) + marks(group), over(group, vertices, as_number())};
  for (const std::string& name : stages) {
    const bool some = std::any_of(group.begin(), group.end(),
                                  [&](const RunRecord* run) { return find_stage(*run, name) != nullptr; });
    row.push_back(
        some ? over_timed(
                   runs, group, [&name](const RunRecord& run) { return wall_seconds(run, name); }, to_significant(3))
             : TableCell("–"));
  }
  row.push_back(over_timed(
      runs, group, [](const RunRecord& run) { return wall_seconds(run, whole_method); }, to_significant(3)));
  row.push_back(over_timed(runs, group, parallel, to_places(2)));
  row.push_back(over_timed(runs, group, microseconds_a_vertex, to_significant(3)));
  return row;
}

}  // namespace

std::vector<Table> stage_tables(const RunGrid& runs) {
  std::vector<std::string> methods;
  for (const Variant& variant : runs.variants) {
    if (std::find(methods.begin(), methods.end(), variant.method) == methods.end()) methods.push_back(variant.method);
  }
  std::vector<Table> tables;
  for (const std::string& method : methods) {
    const std::vector<std::string> stages = stages_of(runs, method);
    if (stages.size() < 2) continue;
    Table table;
    table.title = "Seconds by stage: " + method;
    table.header = {"Data", "Method", "vertices"};
    for (const std::string& name : stages) table.header.push_back(name.substr(whole_method.size() + 1));
    table.header.insert(table.header.end(), {"total", "CPU / wall", "µs per vertex"});
    table.remarks = {
        "Wall seconds. Time between stages counts only in the column \"total\". CPU / wall is the mean number of busy "
        "cores."};
    say_how_timed(runs, table);
    for (const std::string& dataset : runs.datasets) {
      for (const Variant& variant : runs.variants) {
        if (variant.method == method && !finished(find_runs(variant, dataset)).empty())
          table.rows.push_back(stage_row(runs, dataset, variant, stages));
      }
    }
    tables.push_back(std::move(table));
  }
  return tables;
}

}  // namespace isobench
