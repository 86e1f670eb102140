// The columns of results.csv and what stands in them.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "isobench/metrics/measurement.h"
#include "isobench/reports/csv/results_csv.h"
#include "isobench/reports/text/markdown.h"

namespace isobench {

namespace {

// What is no figure of a metric.
std::vector<CsvColumn> asked_columns() {
  return {
      {"run", "", "Name of the run and of its folder; its tail is a hash of all that determines the result."},
      {"dataset", "", "What was meshed: a name of `isobench list datasets`, or the path of a manifest."},
      {"method", "", "What meshed it: a name of `isobench list methods`."},
      {"label", "", "Tells apart two entries of one method in one experiment; else the method's name."},
      {"parameters", "", "The method's own parameters, complete: name=value, joined by semicolons."},
      {"epsilon", "", "Adaptive sizing: edges up to 2 epsilon times the local feature size; else empty."},
      {"delta", "", "Adaptive sizing: Lipschitz bound of the sizing field; else empty."},
      {"edge_length", "mm",
       "Uniform sizing: the edge length asked for or, where a number of vertices was, that which it came to; else "
       "empty."},
      {"match_scale", "", "Factor that matching put on the edge lengths asked for; 1 where nothing was matched."},
      {"seed", "", "Of everything random."},
      {"status", "",
       "ok; failed: an error or a crash; timeout: stopped at its limit of minutes; out of memory: stopped at its limit "
       "of memory, or an allocation failed; skipped: the method cannot do this task, by its own word. Figures and "
       "costs "
       "are empty where it is not ok."},
      {"reason", "", "Why the status is not ok; else empty."}};
}

std::vector<CsvColumn> cost_columns() {
  return {
      {"seconds_prepare", "s", "Wall time of reading and preparing the volume."},
      {"seconds_sizing", "s", "Wall time of the sizing field that the method asked for; 0 where it asked for none."},
      {"seconds_method", "s", "Wall time of the method without its sizing field."},
      {"seconds_total", "s",
       "Sizing and method together: from the prepared volume in memory to the finished mesh, metrics and files "
       "excluded."},
      {"peak_memory_mb", "MB",
       "Largest memory that the run's process, or a program that it ran, had resident up to the finished mesh; 1 MB is "
       "1,000,000 bytes."},
      {"repeat", "", "Which of several runs of one cell, made for their seconds, this is; counts from 1."},
      {"mesh_checksum", "", "Checksum of the finished mesh: the same for meshes that agree bit for bit."},
      {"match_to", "", "The run whose number of vertices this one was brought to; else empty."},
      {"match_vertices", "", "That number; else empty."},
      {"match_reason", "", "Why the number of vertices is not within 2 % of it; empty where it is."},
      {"host", "", "The machine that it ran on: seconds of different machines do not compare."},
      {"exclusive", "", "Whether a scheduler gave the whole machine to the run: true or false."}};
}

CsvColumn figure_column(const std::string& name) {
  for (const MetricDefinition& metric : metric_definitions()) {
    if (metric.name == name) return {metric.name, metric.unit, metric.definition};
  }
  throw std::logic_error("no metric defines the column " + name);
}

}  // namespace

const std::vector<CsvColumn>& csv_columns() {
  static const std::vector<CsvColumn> columns = [] {
    std::vector<CsvColumn> all = asked_columns();
    for (const char* name : {"vertices",
                             "triangles",
                             "radius_ratio_min",
                             "radius_ratio_p01",
                             "radius_ratio_avg",
                             "angle_min",
                             "angle_max",
                             "valence_lt5_percent",
                             "valence_5_percent",
                             "valence_6_percent",
                             "valence_7_percent",
                             "valence_gt7_percent",
                             "valence_extreme_count",
                             "edge_over_h0_max",
                             "edge_over_h0_exceed_percent",
                             "edge_over_h0_exceed_count",
                             "edge_over_own_h0_max",
                             "edge_over_own_h0_exceed_percent",
                             "floor_area_percent",
                             "components",
                             "components_reference",
                             "euler",
                             "euler_reference",
                             "reference_k",
                             "boundary_edges",
                             "nonmanifold_edges",
                             "nonmanifold_vertices",
                             "self_intersections",
                             "distance_mean",
                             "distance_max"}) {
      all.push_back(figure_column(name));
    }
    const std::vector<CsvColumn> costs = cost_columns();
    all.insert(all.end(), costs.begin(), costs.end());
    // Later figures come last, so that a column once known by its place keeps it.
    for (const char* name : {"distance_from_surface_mean", "distance_from_surface_max"})
      all.push_back(figure_column(name));
    return all;
  }();
  return columns;
}

std::string columns_text() {
  MarkdownTable table({"Column", "Unit", "What stands in it"});
  for (const CsvColumn& column : csv_columns()) table.add({column.name, column.unit, column.definition});
  return "# The columns of results.csv\n\n"
         "One row a run, in the order of the plan. Numbers are not rounded; an empty cell is a figure that the run "
         "does "
         "not have. Percent are 0 to 100.\n\n" +
         table.text();
}

}  // namespace isobench
