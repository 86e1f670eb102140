#include "isobench/reports/claims/trends.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>

#include "isobench/reports/claims/claimed_values.h"

namespace isobench {

namespace {

const std::optional<double>& parameter(const RunRecord& run, const std::string& name) {
  const SizingRequest& sizing = run.request.sizing;
  return name == "epsilon" ? sizing.epsilon : sizing.delta;
}

std::string other_than(const std::string& varied) { return varied == "epsilon" ? "delta" : "epsilon"; }
std::string letter(const std::string& name) { return name == "epsilon" ? "ε" : "δ"; }

bool has_epsilon_and_delta(const RunRecord& run) { return run.request.sizing.epsilon && run.request.sizing.delta; }

// Runs that differ in one parameter of the sizing alone.
struct TrendSeries {
  Runs runs;

  bool accepts(const RunRecord& run, const std::string& varied) const {
    const RunRequest& a = runs.front()->request;
    const RunRequest& b = run.request;
    return a.dataset == b.dataset && a.dataset_checksum == b.dataset_checksum && a.method == b.method &&
           a.method_revision == b.method_revision && a.label == b.label && a.parameters == b.parameters &&
           a.match_to == b.match_to && a.sizing.floor == b.sizing.floor &&
           parameter(*runs.front(), other_than(varied)) == parameter(run, other_than(varied));
  }

  bool has_two_values(const std::string& varied) const {
    return std::any_of(runs.begin(), runs.end(), [&](const RunRecord* run) {
      return parameter(*run, varied) != parameter(*runs.front(), varied);
    });
  }

  // "rounded-box, unfinished particles, δ 0.3": what all of its runs share.
  std::string name(const std::string& varied) const {
    const RunRecord& run = *runs.front();
    const RunRequest& request = run.request;
    std::string text = request.dataset;
    if (request.label != request.method) text += ", " + request.label;
    text += fmt::format(", {} {}", letter(other_than(varied)), *parameter(run, other_than(varied)));
    if (request.sizing.floor != SizingRequest{}.floor) text += fmt::format(", floor {} voxels", request.sizing.floor);
    return text;
  }
};

std::vector<TrendSeries> series_of(const Runs& runs, const std::string& varied) {
  std::vector<TrendSeries> all;
  for (const RunRecord* run : runs) {
    auto found =
        std::find_if(all.begin(), all.end(), [&](const TrendSeries& series) { return series.accepts(*run, varied); });
    if (found == all.end()) found = all.insert(all.end(), TrendSeries{});
    found->runs.push_back(run);
  }
  // A data set that was run with only one value was not meant to show a trend.
  std::erase_if(all, [&varied](const TrendSeries& series) { return !series.has_two_values(varied); });
  return all;
}

std::vector<TrendSeries> series_of_method(const Results& results, const std::string& method,
                                          const std::string& varied) {
  Runs first_choice;
  Runs all;
  for (const RunRecord& run : results.records) {
    if (run.request.method != method || !has_epsilon_and_delta(run)) continue;
    all.push_back(&run);
    if (run.request.label == method || run.request.aside) first_choice.push_back(&run);
  }
  std::vector<TrendSeries> series = series_of(first_choice, varied);
  return series.empty() ? series_of(all, varied) : series;
}

// Whether the median of the figure changes as claimed at every step from the largest value of the parameter down.
Finding finding_of(const PublishedClaim& claim, const PublishedMethod& method, const TrendSeries& series) {
  std::map<double, Runs, std::greater<>> steps;
  for (const RunRecord* run : series.runs) steps[*parameter(*run, claim.smaller)].push_back(run);
  Finding finding;
  finding.data = series.name(claim.smaller);
  std::optional<double> before;
  bool all_hold = true;
  for (const auto& [value, runs] : steps) {
    const ClaimedValue claimed = claimed_value(claim, method, runs);
    const std::string step = fmt::format("{} {}: ", letter(claim.smaller), value);
    if (!claimed.absent.empty()) {
      append_to_list(finding.remark, ", ", step + claimed.absent);
      continue;
    }
    append_to_list(finding.ours, ", ", step + median_and_range(claimed));
    if (before) {
      // Medians, because the worst triangle of a single mesh is not typical.
      all_hold = all_hold && (claim.gives_larger ? claimed.median > *before : claimed.median < *before);
      finding.verdict = all_hold ? Verdict::held : Verdict::not_held;
    }
    before = claimed.median;
  }
  return finding;
}

Finding untestable(const PublishedClaim& claim, const PublishedMethod& method, const Results& results) {
  const std::vector<std::string> names = methods_for(method);
  const bool any = std::any_of(results.records.begin(), results.records.end(), [&names](const RunRecord& run) {
    return has_epsilon_and_delta(run) && std::find(names.begin(), names.end(), run.request.method) != names.end();
  });
  const std::string why =
      any ? "no two runs differ in " + claim.smaller + " alone" : method.name + " was not run with epsilon and delta";
  return {"–", Verdict::not_testable, "", "", why};
}

}  // namespace

std::vector<Finding> trend_findings(const PublishedClaim& claim, const Results& results) {
  const PublishedMethod& method = printed_method(*results.published, claim.method);
  for (const std::string& name : methods_for(method)) {
    std::vector<Finding> findings;
    for (const TrendSeries& series : series_of_method(results, name, claim.smaller))
      findings.push_back(finding_of(claim, method, series));
    if (!findings.empty()) return findings;
  }
  return {untestable(claim, method, results)};
}

}  // namespace isobench
