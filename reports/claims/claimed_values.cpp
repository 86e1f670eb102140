#include "isobench/reports/claims/claimed_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/tables/table_parts.h"
#include "isobench/reports/text/markdown.h"

namespace isobench {

namespace {

bool strong(Relation relation) { return relation == Relation::far_above || relation == Relation::far_below; }

bool far(double larger, double smaller, double factor) { return larger > smaller && larger >= factor * smaller; }

}  // namespace

const PublishedMethod& printed_method(const Published& published, const std::string& printed) {
  return *std::find_if(published.methods.begin(), published.methods.end(),
                       [&printed](const PublishedMethod& method) { return method.printed == printed; });
}

Runs runs_for(const Results& results, const PublishedMethod& method) {
  std::vector<std::string> names = {method.name};
  names.insert(names.end(), method.beside.begin(), method.beside.end());
  for (const std::string& name : names) {
    Runs all;
    Runs plain;
    for (const RunRecord& record : results.records) {
      if (record.request.method != name || record.request.aside) continue;
      all.push_back(&record);
      if (record.request.label == name) plain.push_back(&record);
    }
    if (!plain.empty()) return plain;
    if (!all.empty()) return all;
  }
  return {};
}

ClaimedValue claimed_value(const PublishedClaim& claim, const PublishedMethod& method, const Runs& runs) {
  ClaimedValue side;
  side.name = runs.empty() ? method.name : runs.front()->request.label;
  if (runs.empty()) side.absent = method.name + " was not run";
  std::vector<double> values;
  for (const RunRecord* run : runs) {
    double value = 0.0;
    for (const std::string& figure : claim.figures) value += figure_value(*run, figure);
    if (!std::isfinite(value)) {
      const bool failed = run->status != Status::ok;
      side.absent = side.name + (failed ? ": " + to_string(run->status) : " has no such figure");
      continue;
    }
    values.push_back(value);
    side.open = side.open || !dagger(*run).empty();
  }
  if (values.empty()) return side;
  side.absent.clear();
  const Spread spread = spread_of(std::move(values));
  side.low = spread.min;
  side.high = spread.max;
  side.median = spread.median;
  return side;
}

std::string text_of(const ClaimedValue& side) {
  const std::string low = significant(side.low, 3);
  const std::string high = significant(side.high, 3);
  return (low == high ? low : low + "–" + high) + (side.open ? " †" : "");
}

std::string median_text(const ClaimedValue& side) {
  const std::string range = text_of(side);
  return side.low < side.high ? fmt::format("{} ({})", significant(side.median, 3), range) : range;
}

Relation stronger(Relation a, Relation b) {
  if (strong(a) || b == Relation::about) return a;
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
      return far(left.low, right.high, claim.much);
    case Relation::far_below:
      return far(right.low, left.high, claim.much);
  }
  return false;
}

void add_words(std::string& text, const std::string& separator, const std::string& words) {
  if (!words.empty()) text += (text.empty() ? "" : separator) + words;
}

}  // namespace isobench
