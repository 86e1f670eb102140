#include "isobench/reports/claims/claimed_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/tables/table_parts.h"
#include "isobench/reports/text/markdown.h"

namespace isobench {

namespace {

bool is_strong(Relation relation) { return relation == Relation::far_above || relation == Relation::far_below; }

bool is_far_above(double larger, double smaller, double factor) {
  return larger > smaller && larger >= factor * smaller;
}

}  // namespace

ClaimCell claim_cell_of(const RunRecord& record) {
  return {record.request.dataset, sizing_name(record.request.sizing)};
}

std::vector<ClaimCell> claim_cells(const Results& results) {
  std::vector<ClaimCell> cells;
  for (const RunRecord& record : results.records) {
    if (record.request.aside) continue;
    const ClaimCell cell = claim_cell_of(record);
    if (std::find(cells.begin(), cells.end(), cell) == cells.end()) cells.push_back(cell);
  }
  return cells;
}

bool several_sizings(const std::vector<ClaimCell>& cells, const std::string& dataset) {
  return std::count_if(cells.begin(), cells.end(),
                       [&dataset](const ClaimCell& cell) { return cell.dataset == dataset; }) > 1;
}

std::string name_among(const std::vector<ClaimCell>& cells, const ClaimCell& cell) {
  return cell.dataset + (several_sizings(cells, cell.dataset) ? ", " + cell.sizing : "");
}

const PublishedMethod& printed_method(const Published& published, const std::string& printed) {
  return *std::find_if(published.methods.begin(), published.methods.end(),
                       [&printed](const PublishedMethod& method) { return method.printed == printed; });
}

std::vector<std::string> methods_for(const PublishedMethod& method) {
  std::vector<std::string> names = {method.name};
  names.insert(names.end(), method.beside.begin(), method.beside.end());
  return names;
}

Runs runs_for(const Results& results, const PublishedMethod& method) {
  for (const std::string& name : methods_for(method)) {
    Runs all;
    Runs unlabelled;
    for (const RunRecord& record : results.records) {
      if (record.request.method != name || record.request.aside) continue;
      all.push_back(&record);
      if (record.request.label == name) unlabelled.push_back(&record);
    }
    if (!unlabelled.empty()) return unlabelled;
    if (!all.empty()) return all;
  }
  return {};
}

ClaimedValue claimed_value(const PublishedClaim& claim, const PublishedMethod& method, const Runs& runs) {
  ClaimedValue claimed;
  claimed.name = runs.empty() ? method.name : runs.front()->request.label;
  if (runs.empty()) claimed.absent = method.name + " was not run";
  std::vector<double> values;
  for (const RunRecord* run : runs) {
    double value = 0.0;
    for (const std::string& figure : claim.figures) value += figure_value(*run, figure);
    if (!std::isfinite(value)) {
      const bool failed = run->status != Status::ok;
      claimed.absent = claimed.name + (failed ? ": " + to_string(run->status) : " has no such figure");
      continue;
    }
    values.push_back(value);
    claimed.open = claimed.open || !dagger(*run).empty();
  }
  if (values.empty()) return claimed;
  claimed.absent.clear();
  const Spread spread = spread_of(std::move(values));
  claimed.low = spread.min;
  claimed.high = spread.max;
  claimed.median = spread.median;
  return claimed;
}

std::string range_text(const ClaimedValue& value) {
  const std::string low = significant(value.low, 3);
  const std::string high = significant(value.high, 3);
  return (low == high ? low : low + "–" + high) + (value.open ? " †" : "");
}

std::string median_and_range(const ClaimedValue& value) {
  const std::string range = range_text(value);
  return value.low < value.high ? fmt::format("{} ({})", significant(value.median, 3), range) : range;
}

Relation stronger(Relation a, Relation b) {
  if (is_strong(a) || b == Relation::about) return a;
  return b;
}

bool holds(const PublishedClaim& claim, const ClaimedValue& left, Relation relation, const ClaimedValue& right) {
  switch (relation) {
    case Relation::about:
      return std::max(left.high, right.high) - std::min(left.low, right.low) <=
             claim.about * std::max(std::abs(left.high), std::abs(right.high));
    case Relation::above:
      return left.low > right.high;
    case Relation::below:
      return left.high < right.low;
    case Relation::far_above:
      return is_far_above(left.low, right.high, claim.much);
    case Relation::far_below:
      return is_far_above(right.low, left.high, claim.much);
  }
  return false;
}

void append_to_list(std::string& list, const std::string& separator, const std::string& item) {
  if (!item.empty()) list += (list.empty() ? "" : separator) + item;
}

}  // namespace isobench
