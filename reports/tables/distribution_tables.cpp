// Worst cases, quantiles over the data sets, and ranks.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/statistics/sample.h"
#include "isobench/reports/survey/side_by_side.h"
#include "isobench/reports/survey/survey.h"
#include "isobench/reports/tables/survey_tables.h"
#include "isobench/reports/tables/table_parts.h"

namespace isobench {

namespace {

// "0.853 (islands-17)". Where not even the worst has a defect there is no data set to name.
TableCell worst_cell(const WorstCase& worst, const Criterion& criterion) {
  if (worst.run == nullptr) return "–";
  TableCell cell = number_cell(worst.value, criterion.print);
  if (!criterion.larger && worst.value == 0.0) return cell;
  return with_mark(std::move(cell), " (" + worst.run->request.dataset + ")");
}

// The criteria whose worst case says most about a family.
std::vector<const Criterion*> telling_criteria() {
  std::vector<const Criterion*> all;
  for (const char* id : {"radius-ratio-min", "angle-min", "angle-max"}) all.push_back(&quality_criterion(id));
  for (const Criterion& criterion : defect_criteria()) {
    if (criterion.id == "valence" || criterion.id == "edge-over-h0" || criterion.id == "seconds")
      all.push_back(&criterion);
  }
  return all;
}

TableRow distribution_row(const Criterion& criterion, const Variant& method, std::vector<double> values) {
  // From worst to best, whichever direction is better.
  std::sort(values.begin(), values.end());
  const auto at = [&](double p) {
    return number_cell(quantile(values, criterion.larger ? p : 1.0 - p), criterion.print);
  };
  constexpr std::uint64_t seed = 1;
  const Interval sure = bootstrap_median(values, seed);
  return {name_with_unit(criterion),
          method.name,
          number_cell(static_cast<double>(values.size()), as_number()),
          at(0.0),
          at(0.05),
          at(0.25),
          at(0.5),
          number_cell(sure.low, criterion.print),
          number_cell(sure.high, criterion.print),
          at(0.75),
          at(1.0)};
}

std::string p_text(double p) { return p < 1e-6 ? "p < 0.000001" : "p = " + significant(p, 2); }

// What Friedman's test says of one criterion, under the table of ranks.
std::string test_sentence(const Criterion& criterion, const SideBySide& side, double difference) {
  const FriedmanTest test = friedman_test(side.costs);
  return fmt::format("{}: {} methods on {} data sets, Friedman χ² = {}, {}{}, critical difference {:.3f}.",
                     criterion.name, side.methods.size(), side.datasets.size(), significant(test.chi_square, 3),
                     std::isfinite(test.f) ? "F = " + significant(test.f, 3) + ", " : "", p_text(test.p), difference);
}

void add_ranks(const Criterion& criterion, const SideBySide& side, Table& table) {
  const double difference = critical_difference(side.methods.size(), side.datasets.size());
  const std::vector<double> ranks = average_ranks(side.costs);
  std::vector<std::size_t> order(ranks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&ranks](std::size_t a, std::size_t b) { return ranks[a] < ranks[b]; });
  for (const std::size_t m : order) {
    std::vector<std::string> beaten;
    for (const std::size_t other : order) {
      if (ranks[other] - ranks[m] > difference) beaten.push_back(side.methods[other]->name);
    }
    table.rows.push_back({criterion.name, side.methods[m]->name, number_cell(ranks[m], to_places(2)),
                          beaten.empty() ? "–" : fmt::format("{}", fmt::join(beaten, ", "))});
  }
  table.remarks.push_back(test_sentence(criterion, side, difference));
}

std::string failed_checks(const Runs& runs) {
  std::vector<std::string> names;
  for (const Check& each : checks()) {
    const bool failed =
        std::any_of(runs.begin(), runs.end(), [&each](const RunRecord* run) { return passes(each, *run) == false; });
    if (failed) names.push_back(each.name);
  }
  return names.empty() ? "–" : fmt::format("{}", fmt::join(names, ", "));
}

TableRow dataset_row(const RunGrid& runs, const Variant& variant, const std::string& dataset) {
  const Runs& group = find_runs(variant, dataset);
  const auto family = runs.family_of.find(dataset);
  TableRow row = {dataset, family == runs.family_of.end() ? "–" : family->second,
                  variant.name + spread_label(group) + marks(group)};
  const RunRecord* record = find_run(variant, dataset);
  if (record->status != Status::ok) {
    row.push_back(instead_of_figures(record));
    row.resize(10, TableCell("–"));
    return row;
  }
  row.emplace_back(failed_checks(group));
  row.push_back(over(group, vertices, as_number()));
  for (const char* id : {"radius-ratio-min", "radius-ratio-avg", "angle-min", "angle-max"})
    row.push_back(over(group, quality_criterion(id).value, quality_criterion(id).print));
  row.push_back(over_timed(runs, group, figure_of("seconds_total"), to_significant(3)));
  return row;
}

}  // namespace

Table worst_table(const RunGrid& runs) {
  Table table;
  table.title = "Worst cases";
  table.label_columns = 1;
  table.header = {"Figure"};
  const std::vector<const Variant*> methods = surveyed(runs);
  for (const Variant* method : methods) table.header.push_back(method->name);
  for (const std::vector<Criterion>* list : {&quality_criteria(), &defect_criteria()}) {
    for (const Criterion& criterion : *list) {
      TableRow row = {name_with_unit(criterion)};
      for (const Variant* method : methods) row.push_back(worst_cell(worst_case(runs, *method, criterion), criterion));
      table.rows.push_back(std::move(row));
    }
  }
  table.remarks = {
      "The worst value over all finished runs, open meshes included, and the data set where it occurs; of equally bad "
      "ones the first. Data sets without a mesh are in the table of reliability."};
  say_how_timed(runs, table);
  return table;
}

Table family_table(const RunGrid& runs) {
  Table table;
  table.title = "Families and their worst cases";
  table.header = {"Family", "Method", "Data sets", "Sound"};
  for (const Criterion* criterion : telling_criteria()) table.header.push_back(name_with_unit(*criterion));
  for (const Variant* method : surveyed(runs)) {
    for (const std::string& family : families_of(runs)) {
      const Tally counts = tally(runs, *method, family);
      if (counts.datasets == 0) continue;
      TableRow row = {
          family, method->name, number_cell(static_cast<double>(counts.datasets), as_number()),
          counts.sound.asked == 0 ? "not measured" : fmt::format("{} of {}", counts.sound.passed, counts.sound.asked)};
      for (const Criterion* criterion : telling_criteria())
        row.push_back(worst_cell(worst_case(runs, *method, *criterion, family), *criterion));
      table.rows.push_back(std::move(row));
    }
  }
  table.remarks = {
      "A mesh is sound if it is a closed manifold with the right topology and without self-intersections. The other "
      "columns show the worst value of the family and the data set where it occurs."};
  return table;
}

Table distribution_table(const RunGrid& runs) {
  Table table;
  table.title = "Distributions over the data sets";
  table.header = {"Figure", "Method",        "Data sets", "worst",           "worst 5 %", "worse quartile",
                  "median", "95 % interval", "to",        "better quartile", "best"};
  for (const Criterion& criterion : quality_criteria()) {
    for (const Variant* method : surveyed(runs)) {
      std::vector<double> values = values_over(runs, *method, criterion);
      if (!values.empty()) table.rows.push_back(distribution_row(criterion, *method, std::move(values)));
    }
  }
  table.remarks = {
      "One value for each data set with a mesh. 5 % of the data sets are worse than the value under \"worst 5 %\", a "
      "quarter are worse than the worse quartile. The 95 % interval is that of the median, from 2000 bootstrap samples "
      "of the data sets. Methods that ran on different data sets must not be compared here: see the ranks."};
  say_how_timed(runs, table);
  return table;
}

Table rank_table(const RunGrid& runs) {
  Table table;
  table.title = "Average ranks";
  table.header = {"Figure", "Method", "average rank", "significantly better than"};
  table.remarks = {
      "Rank 1 is the best method on a data set; equal values share their mean rank. Only data sets on which every "
      "method "
      "has a run count. A method without a closed manifold there has the last rank. Friedman's test (with Iman and "
      "Davenport's F) says whether the ranks differ at all. Two ranks that differ by more than Nemenyi's critical "
      "difference differ significantly (α = 0.05)."};
  for (const Criterion& criterion : quality_criteria()) {
    const SideBySide side = side_by_side(runs, criterion);
    if (!side.empty()) add_ranks(criterion, side, table);
  }
  return table;
}

Table dataset_table(const RunGrid& runs) {
  Table table;
  table.title = "Each data set";
  table.label_columns = 3;
  table.header = {"Data", "Family", "Method", "Not passed", "vertices"};
  for (const char* id : {"radius-ratio-min", "radius-ratio-avg", "angle-min", "angle-max"})
    table.header.push_back(name_with_unit(quality_criterion(id)));
  table.header.emplace_back("seconds");
  for (const std::string& dataset : runs.datasets) {
    for (const Variant& variant : runs.variants) {
      if (variant.runs.contains(dataset)) table.rows.push_back(dataset_row(runs, variant, dataset));
    }
  }
  say_how_timed(runs, table);
  return table;
}

std::vector<Table> survey_tables(const RunGrid& runs) {
  std::vector<Table> tables = {reliability_table(runs),       outlier_table(runs), worst_table(runs),
                               distribution_table(runs),      rank_table(runs),    family_table(runs),
                               family_reliability_table(runs)};
  std::erase_if(tables, [](const Table& table) { return table.empty(); });
  return tables;
}

}  // namespace isobench
