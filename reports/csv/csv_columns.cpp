// The columns of results.csv and their definitions.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

#include "isobench/reports/csv/results_csv.h"
#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/runs/checks.h"
#include "isobench/reports/text/markdown.h"

namespace isobench {

namespace {

std::vector<CsvColumn> asked_columns() {
  return {
      {"run", "", "Name of the run and of its folder. It ends in a hash of everything that determines the result."},
      {"dataset", "", "The data set: a name of `isobench list datasets`, or the path of a manifest."},
      {"method", "", "The method: a name of `isobench list methods`."},
      {"label", "", "Name of the method's entry in the experiment; the method's name unless the entry has a label."},
      {"parameters", "", "All parameters of the method: name=value, joined by semicolons."},
      {"epsilon", "", "Adaptive sizing: edges are up to 2 epsilon times the local feature size; else empty."},
      {"delta", "", "Adaptive sizing: Lipschitz bound of the sizing field; else empty."},
      {"edge_length", "mm",
       "Uniform sizing: the requested edge length or, if a number of vertices was requested, the edge length found for "
       "it; else empty."},
      {"match_scale", "", "Factor by which matching scaled the requested edge lengths; 1 without matching."},
      {"seed", "", "Seed of all random numbers."},
      {"status", "",
       "ok; failed: an error or a crash; timeout: stopped at its limit of minutes; out of memory: stopped at its limit "
       "of memory, or an allocation failed; skipped: the method says that it cannot do this task. Figures and costs "
       "are empty unless it is ok."},
      {"reason", "", "Why the status is not ok; else empty."}};
}

// The columns after those of seconds and memory.
std::vector<CsvColumn> circumstance_columns() {
  return {{"repeat", "", "Number of the repeat, counted from 1. A run is repeated to measure its seconds again."},
          {"mesh_checksum", "", "Checksum of the finished mesh. Meshes that agree bit for bit have the same checksum."},
          {"match_to", "", "The run whose number of vertices this run was matched to; else empty."},
          {"match_vertices", "", "The number of vertices of the run in match_to; else empty."},
          {"match_reason", "", "Why the number of vertices is not within 2 % of match_vertices; else empty."},
          {"host", "", "The machine of the run. Seconds from different machines must not be compared."},
          {"exclusive", "", "true if a scheduler gave the whole machine to the run, else false."}};
}

// What statistics over many data sets need besides the figures.
std::vector<CsvColumn> survey_columns() {
  std::vector<CsvColumn> columns = {
      {"family", "", "The family of data sets that this one is a member of; empty if it is of none."}};
  for (const Check& check : checks()) columns.push_back({check.column, "", check.definition + " true or false."});
  return columns;
}

void add(const std::vector<CsvColumn>& more, std::vector<CsvColumn>& columns) {
  columns.insert(columns.end(), more.begin(), more.end());
}

CsvColumn column_of(const FigureDeclaration& figure) { return {figure.name, figure.unit, full_definition(figure)}; }

// The figures with lowest <= column < highest, sorted by column; if equal, in the order of the metrics.
std::vector<CsvColumn> figure_columns(int lowest, int highest) {
  std::vector<const FigureDeclaration*> chosen;
  for (const FigureDeclaration& figure : declared_figures()) {
    if (figure.column != no_column && figure.column >= lowest && figure.column < highest) chosen.push_back(&figure);
  }
  std::stable_sort(chosen.begin(), chosen.end(),
                   [](const FigureDeclaration* a, const FigureDeclaration* b) { return a->column < b->column; });
  std::vector<CsvColumn> columns;
  for (const FigureDeclaration* figure : chosen) columns.push_back(column_of(*figure));
  return columns;
}

// A metric may choose any name for its figure, even the name of another column.
void check_names(const std::vector<CsvColumn>& columns) {
  std::set<std::string> names;
  for (const CsvColumn& column : columns) {
    if (!names.insert(column.name).second)
      throw std::logic_error("results.csv has two columns named " + column.name + "; a metric must rename its figure");
  }
}

}  // namespace

const std::vector<CsvColumn>& csv_columns() {
  static const std::vector<CsvColumn> columns = [] {
    std::vector<CsvColumn> all = asked_columns();
    add(figure_columns(std::numeric_limits<int>::min(), cost_columns), all);
    for (const CostDeclaration& cost : cost_declarations()) all.push_back(column_of(cost.figure));
    add(circumstance_columns(), all);
    add(figure_columns(cost_columns, std::numeric_limits<int>::max()), all);
    add(survey_columns(), all);
    check_names(all);
    return all;
  }();
  return columns;
}

std::string columns_text() {
  MarkdownTable table({"Column", "Unit", "Definition"});
  for (const CsvColumn& column : csv_columns()) table.add({column.name, column.unit, column.definition});
  return "# The columns of results.csv\n\n"
         "One row for each run, in the order of the plan. Numbers are not rounded. A figure that was not measured is "
         "an empty cell. Percentages run from 0 to 100.\n\n" +
         table.text();
}

}  // namespace isobench
