#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <set>

#include "isobench/reports/claims/claimed_values.h"

namespace isobench {

namespace {

std::string published_figures(const Results& results, const PublishedClaim& claim, const std::string& dataset) {
  std::string text;
  const std::vector<std::string> methods = claim.order.empty() ? std::vector{claim.method} : claim.order;
  for (const std::string& printed : methods) {
    const PublishedMethod& method = printed_method(*results.published, printed);
    const PublishedFigure* figure = results.published->find(claim.quantity, dataset, method.name);
    if (figure != nullptr) add_words(text, ", ", printed + " " + figure->printed);
  }
  return text;
}

Finding order_finding(const PublishedClaim& claim, const std::vector<ClaimedValue>& sides) {
  Finding finding;
  bool all_hold = true;
  const ClaimedValue* last = nullptr;
  Relation relation = Relation::about;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i > 0) relation = stronger(relation, claim.relations[i - 1]);
    add_words(finding.remark, ", ", sides[i].absent);
    if (!sides[i].absent.empty()) continue;
    add_words(finding.ours, ", ", sides[i].name + " " + text_of(sides[i]));
    if (last != nullptr) {
      all_hold = all_hold && holds(claim, *last, relation, sides[i]);
      finding.verdict = all_hold ? Verdict::held : Verdict::not_held;
    }
    last = &sides[i];
    relation = Relation::about;
  }
  return finding;
}

Finding bound_finding(const PublishedClaim& claim, const ClaimedValue& side) {
  Finding finding;
  finding.remark = side.absent;
  if (!side.absent.empty()) return finding;
  const bool held = (!claim.at_most || side.high <= *claim.at_most) && (!claim.at_least || side.low >= *claim.at_least);
  finding.verdict = held ? Verdict::held : Verdict::not_held;
  finding.ours = side.name + " " + text_of(side);
  return finding;
}

// The runs of an experiment that belong side by side: one data set, one sizing.
struct Cell {
  std::string dataset;
  std::string sizing;
  bool operator==(const Cell&) const = default;
};
Cell cell_of(const RunRecord& record) { return {record.request.dataset, sizing_name(record.request.sizing)}; }

std::vector<Cell> cells_of(const Results& results) {
  std::vector<Cell> cells;
  for (const RunRecord& record : results.records) {
    if (record.request.aside) continue;
    const Cell cell = cell_of(record);
    if (std::find(cells.begin(), cells.end(), cell) == cells.end()) cells.push_back(cell);
  }
  return cells;
}

bool several_sizings(const std::vector<Cell>& cells, const std::string& dataset) {
  return std::count_if(cells.begin(), cells.end(), [&](const Cell& cell) { return cell.dataset == dataset; }) > 1;
}

// Only the runs of one cell.
Runs within(const Cell& cell, Runs runs) {
  std::erase_if(runs, [&cell](const RunRecord* run) { return cell_of(*run) != cell; });
  return runs;
}

std::vector<ClaimedValue> sides_in(const PublishedClaim& claim, const Results& results, const Cell& cell) {
  std::vector<ClaimedValue> sides;
  const std::vector<std::string> methods = claim.order.empty() ? std::vector{claim.method} : claim.order;
  for (const std::string& printed : methods) {
    const PublishedMethod& method = printed_method(*results.published, printed);
    sides.push_back(claimed_value(claim, method, within(cell, runs_for(results, method))));
  }
  return sides;
}

std::vector<Finding> findings_per_cell(const PublishedClaim& claim, const Results& results) {
  std::vector<Finding> findings;
  const std::vector<Cell> cells = cells_of(results);
  for (const Cell& cell : cells) {
    const std::vector<ClaimedValue> sides = sides_in(claim, results, cell);
    Finding finding = claim.order.empty() ? bound_finding(claim, sides.front()) : order_finding(claim, sides);
    finding.data = cell.dataset + (several_sizings(cells, cell.dataset) ? ", " + cell.sizing : "");
    finding.published = published_figures(results, claim, cell.dataset);
    findings.push_back(std::move(finding));
  }
  return findings;
}

// The mean of each method over the data sets on which all methods that were run at all have finished.
Finding average_finding(const PublishedClaim& claim, const Results& results) {
  Finding finding;
  finding.data = "average";
  const std::vector<Cell> cells = cells_of(results);
  std::vector<ClaimedValue> means(claim.order.size());
  int count = 0;
  std::string left_out;
  for (const Cell& cell : cells) {
    if (several_sizings(cells, cell.dataset)) {
      finding.remark = "no mean over several sizings of one data set";
      return finding;
    }
    const std::vector<ClaimedValue> sides = sides_in(claim, results, cell);
    std::string missing;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const bool run_at_all = !runs_for(results, printed_method(*results.published, claim.order[i])).empty();
      if (run_at_all) add_words(missing, ", ", sides[i].absent);
    }
    if (!missing.empty()) {
      add_words(left_out, ", ", cell.dataset + " left out, as " + missing);
      continue;
    }
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (count == 0) means[i] = {sides[i].name, 0.0, 0.0, 0.0, false, sides[i].absent};
      means[i].low += sides[i].low;
      means[i].high += sides[i].high;
      means[i].open = means[i].open || sides[i].open;
    }
    ++count;
  }
  for (ClaimedValue& mean : means) {
    mean.low /= count;
    mean.high /= count;
  }
  if (count > 0) finding = order_finding(claim, means);
  finding.data = count > 1 ? fmt::format("average of {}", count) : "average";
  finding.published = published_figures(results, claim, "average");
  add_words(finding.remark, ", ", left_out);
  return finding;
}

double sampling_value(const SizingRequest& sizing, const std::string& name) {
  return (name == "epsilon" ? sizing.epsilon : sizing.delta).value_or(std::numeric_limits<double>::quiet_NaN());
}

// Data set and everything of the sizing but the parameter that goes down, in words.
std::string series_name(const RunRecord& record, const std::string& varied) {
  const SizingRequest& sizing = record.request.sizing;
  const bool epsilon = varied == "epsilon";
  std::string name = fmt::format("{}, {} {}", record.request.dataset, epsilon ? "δ" : "ε",
                                 sampling_value(sizing, epsilon ? "delta" : "epsilon"));
  return sizing.floor == SizingRequest{}.floor ? name : name + fmt::format(", floor {} voxels", sizing.floor);
}

Finding trend_finding(const PublishedClaim& claim, const PublishedMethod& method, const Runs& runs) {
  std::map<double, Runs, std::greater<>> steps;
  for (const RunRecord* run : runs) steps[sampling_value(run->request.sizing, claim.smaller)].push_back(run);
  Finding finding;
  std::optional<ClaimedValue> last;
  bool all_hold = true;
  for (const auto& [value, group] : steps) {
    const ClaimedValue side = claimed_value(claim, method, group);
    const std::string where = fmt::format("{} {}: ", claim.smaller == "epsilon" ? "ε" : "δ", value);
    if (!side.absent.empty()) {
      add_words(finding.remark, ", ", where + side.absent);
      continue;
    }
    add_words(finding.ours, ", ", where + median_text(side));
    if (last) {
      // Of the medians: a trend is of what is typical, and one mesh's worst triangle is not.
      all_hold = all_hold && (claim.gives_larger ? side.median > last->median : side.median < last->median);
      finding.verdict = all_hold ? Verdict::held : Verdict::not_held;
    }
    last = side;
  }
  return finding;
}

std::vector<Finding> trend_findings(const PublishedClaim& claim, const Results& results) {
  const PublishedMethod& method = printed_method(*results.published, claim.method);
  std::vector<std::pair<std::string, Runs>> series;
  for (const RunRecord* run : runs_for(results, method)) {
    if (!run->request.sizing.epsilon) continue;
    const std::string name = series_name(*run, claim.smaller);
    auto found = std::find_if(series.begin(), series.end(), [&name](const auto& one) { return one.first == name; });
    if (found == series.end()) found = series.insert(series.end(), {name, {}});
    found->second.push_back(run);
  }
  std::vector<Finding> findings;
  for (const auto& [name, runs] : series) {
    Finding finding = trend_finding(claim, method, runs);
    finding.data = name;
    // A data set with a single value of the parameter was never meant to show a trend.
    if (finding.verdict != Verdict::not_testable || !finding.remark.empty()) findings.push_back(std::move(finding));
  }
  if (findings.empty()) {
    const std::string why = series.empty() ? method.name + " was not run with epsilon and delta"
                                           : "no two runs differ in " + claim.smaller + " alone";
    findings.push_back({"–", Verdict::not_testable, "", "", why});
  }
  return findings;
}

// Which data sets a summary speaks of, and why not of all.
void summarize(ClaimResult& result) {
  std::string against;
  std::string untested;
  std::set<std::string> remarks;
  std::size_t tested = 0;
  for (const Finding& finding : result.findings) {
    if (finding.verdict == Verdict::not_held) add_words(against, "; ", finding.data);
    if (finding.verdict == Verdict::not_testable) add_words(untested, "; ", finding.data);
    tested += finding.verdict == Verdict::not_testable ? 0 : 1;
    if (!finding.remark.empty()) remarks.insert(finding.remark);
  }
  const std::string why = fmt::format("{}", fmt::join(remarks, "; "));
  if (tested == 0) {
    result.verdict = Verdict::not_testable;
    result.summary = to_string(result.verdict) + (why.empty() ? "" : ": " + why);
    return;
  }
  result.verdict = against.empty() ? Verdict::held : Verdict::not_held;
  result.summary = to_string(result.verdict);
  if (!against.empty() && result.findings.size() > 1) result.summary += " on " + against;
  if (against.empty() && !why.empty()) result.summary += " as far as it can be tested here";
  if (!untested.empty() && against.empty()) result.summary += ", not on " + untested;
  if (!why.empty()) result.summary += " (" + why + ")";
}

}  // namespace

std::string to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::held:
      return "held";
    case Verdict::not_held:
      return "not held";
    case Verdict::not_testable:
      return "not testable here";
  }
  return "not testable here";
}

ClaimResult evaluate(const PublishedClaim& claim, const Results& results) {
  ClaimResult result;
  if (!claim.smaller.empty())
    result.findings = trend_findings(claim, results);
  else if (claim.average)
    result.findings = {average_finding(claim, results)};
  else
    result.findings = findings_per_cell(claim, results);
  summarize(result);
  return result;
}

}  // namespace isobench
