#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "isobench/reports/claims/across_methods.h"
#include "isobench/reports/claims/claimed_values.h"
#include "isobench/reports/claims/convergence.h"
#include "isobench/reports/claims/trends.h"

namespace isobench {

namespace {

std::string published_figures(const Results& results, const PublishedClaim& claim, const std::string& dataset) {
  std::string text;
  const std::vector<std::string> methods = claim.order.empty() ? std::vector{claim.method} : claim.order;
  for (const std::string& printed : methods) {
    const PublishedMethod& method = printed_method(*results.published, printed);
    const PublishedFigure* figure = results.published->find(claim.quantity, dataset, method.name);
    if (figure != nullptr) append_to_list(text, ", ", printed + " " + figure->printed);
  }
  return text;
}

Finding order_finding(const PublishedClaim& claim, const std::vector<ClaimedValue>& values) {
  Finding finding;
  bool all_hold = true;
  const ClaimedValue* last = nullptr;
  Relation relation = Relation::about;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) relation = stronger(relation, claim.relations[i - 1]);
    append_to_list(finding.remark, ", ", values[i].absent);
    if (!values[i].absent.empty()) continue;
    append_to_list(finding.ours, ", ", values[i].name + " " + range_text(values[i]));
    if (last != nullptr) {
      all_hold = all_hold && holds(claim, *last, relation, values[i]);
      finding.verdict = all_hold ? Verdict::held : Verdict::not_held;
    }
    last = &values[i];
    relation = Relation::about;
  }
  return finding;
}

Finding bound_finding(const PublishedClaim& claim, const ClaimedValue& value) {
  Finding finding;
  finding.remark = value.absent;
  if (!value.absent.empty()) return finding;
  const bool held =
      (!claim.at_most || value.high <= *claim.at_most) && (!claim.at_least || value.low >= *claim.at_least);
  finding.verdict = held ? Verdict::held : Verdict::not_held;
  finding.ours = value.name + " " + range_text(value);
  return finding;
}

Runs runs_in(const ClaimCell& cell, Runs runs) {
  std::erase_if(runs, [&cell](const RunRecord* run) { return claim_cell_of(*run) != cell; });
  return runs;
}

std::vector<ClaimedValue> values_in(const PublishedClaim& claim, const Results& results, const ClaimCell& cell) {
  std::vector<ClaimedValue> values;
  const std::vector<std::string> methods = claim.order.empty() ? std::vector{claim.method} : claim.order;
  for (const std::string& printed : methods) {
    const PublishedMethod& method = printed_method(*results.published, printed);
    values.push_back(claimed_value(claim, method, runs_in(cell, runs_for(results, method))));
  }
  return values;
}

std::vector<Finding> findings_per_cell(const PublishedClaim& claim, const Results& results) {
  std::vector<Finding> findings;
  const std::vector<ClaimCell> cells = claim_cells(results);
  for (const ClaimCell& cell : cells) {
    const std::vector<ClaimedValue> values = values_in(claim, results, cell);
    Finding finding = claim.order.empty() ? bound_finding(claim, values.front()) : order_finding(claim, values);
    finding.data = name_among(cells, cell);
    finding.published = published_figures(results, claim, cell.dataset);
    findings.push_back(std::move(finding));
  }
  return findings;
}

// The mean of each method over the data sets on which every method has a value. A method without a single run is left
// out, so that the others can still be compared.
Finding average_finding(const PublishedClaim& claim, const Results& results) {
  Finding finding;
  finding.data = "average";
  const std::vector<ClaimCell> cells = claim_cells(results);
  std::vector<ClaimedValue> means(claim.order.size());
  int count = 0;
  std::string left_out;
  for (const ClaimCell& cell : cells) {
    if (several_sizings(cells, cell.dataset)) {
      finding.remark = "no mean over several sizings of one data set";
      return finding;
    }
    const std::vector<ClaimedValue> values = values_in(claim, results, cell);
    std::string missing;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const bool run_at_all = !runs_for(results, printed_method(*results.published, claim.order[i])).empty();
      if (run_at_all) append_to_list(missing, ", ", values[i].absent);
    }
    if (!missing.empty()) {
      append_to_list(left_out, ", ", cell.dataset + " left out, as " + missing);
      continue;
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (count == 0) means[i] = {values[i].name, 0.0, 0.0, 0.0, false, values[i].absent};
      means[i].low += values[i].low;
      means[i].high += values[i].high;
      means[i].open = means[i].open || values[i].open;
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
  append_to_list(finding.remark, ", ", left_out);
  return finding;
}

// The parts of a remark between "; ": findings often share some of them.
void add_parts(const std::string& remark, std::set<std::string>& parts) {
  for (std::size_t start = 0; start < remark.size();) {
    const std::size_t end = std::min(remark.find("; ", start), remark.size());
    parts.insert(remark.substr(start, end - start));
    start = end + 2;
  }
}

void summarize(ClaimResult& result) {
  std::string failed_on;
  std::string untested_on;
  std::set<std::string> remarks;
  constexpr std::size_t most_uncounted = 4;
  std::size_t tested = 0;
  std::size_t failed = 0;
  for (const Finding& finding : result.findings) {
    if (finding.verdict == Verdict::not_held) append_to_list(failed_on, "; ", finding.data);
    failed += finding.verdict == Verdict::not_held ? 1 : 0;
    if (finding.verdict == Verdict::not_testable) append_to_list(untested_on, "; ", finding.data);
    tested += finding.verdict == Verdict::not_testable ? 0 : 1;
    add_parts(finding.remark, remarks);
  }
  const std::string reasons = fmt::format("{}", fmt::join(remarks, "; "));
  if (tested == 0) {
    result.verdict = Verdict::not_testable;
    result.summary = to_string(result.verdict) + (reasons.empty() ? "" : ": " + reasons);
    return;
  }
  result.verdict = failed_on.empty() ? Verdict::held : Verdict::not_held;
  result.summary = to_string(result.verdict);
  if (!failed_on.empty() && result.findings.size() > 1) {
    result.summary += tested > most_uncounted ? fmt::format(" on {} of {}: ", failed, tested) : " on ";
    result.summary += failed_on;
  }
  if (failed_on.empty() && !reasons.empty()) result.summary += " as far as it could be tested";
  if (failed_on.empty() && !untested_on.empty()) result.summary += "; not testable on " + untested_on;
  if (!reasons.empty()) result.summary += " (" + reasons + ")";
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
  else if (claim.across_methods)
    result.findings = across_methods_findings(claim, results);
  else if (claim.convergence)
    result.findings = convergence_findings(claim, results);
  else if (claim.average)
    result.findings = {average_finding(claim, results)};
  else
    result.findings = findings_per_cell(claim, results);
  summarize(result);
  return result;
}

}  // namespace isobench
