#include "isobench/reports/claims/across_methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isobench/reports/claims/claimed_values.h"
#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/statistics/ranking.h"

namespace isobench {

namespace {

struct MethodRuns {
  std::string label;
  Runs runs;
};

std::vector<MethodRuns> methods_in(const ClaimCell& cell, const Results& results) {
  std::vector<MethodRuns> methods;
  for (const RunRecord& record : results.records) {
    const std::string& label = record.request.label;
    if (record.request.aside || claim_cell_of(record) != cell) continue;
    auto method =
        std::find_if(methods.begin(), methods.end(), [&label](const MethodRuns& each) { return each.label == label; });
    if (method == methods.end()) method = methods.insert(method, MethodRuns{label, {}});
    method->runs.push_back(&record);
  }
  return methods;
}

// Medians over the runs of each method that has both figures.
struct Pairs {
  std::vector<double> x;
  std::vector<double> y;
  std::string left_out;
};

bool could_not_be_matched(const MethodRuns& method) {
  return std::any_of(method.runs.begin(), method.runs.end(), [](const RunRecord* run) { return is_unmatched(*run); });
}

// Names the figure that the method lacks, or says how its run ended.
std::string why_left_out(const MethodRuns& method, const std::string& figure) {
  if (finished(method.runs).empty()) return method.label + " left out: " + to_string(method.runs.front()->status);
  return fmt::format("{} left out: no {}", method.label, figure);
}

Pairs pairs_of(const PublishedClaim& claim, const std::vector<MethodRuns>& methods) {
  Pairs pairs;
  for (const MethodRuns& method : methods) {
    if (could_not_be_matched(method)) {
      append_to_list(pairs.left_out, "; ", method.label + " left out: another number of vertices");
      continue;
    }
    std::vector<double> x;
    std::vector<double> y;
    for (const RunRecord* run : counted_runs(method.runs)) {
      x.push_back(figure_value(*run, claim.across_methods->larger));
      y.push_back(0.0);
      for (const std::string& figure : claim.figures) y.back() += figure_value(*run, figure);
    }
    const double of_x = spread_of(std::move(x)).median;
    const double of_y = spread_of(std::move(y)).median;
    if (std::isfinite(of_x) && std::isfinite(of_y)) {
      pairs.x.push_back(of_x);
      pairs.y.push_back(of_y);
      continue;
    }
    const std::string lacks =
        std::isfinite(of_x) ? fmt::format("{}", fmt::join(claim.figures, " + ")) : claim.across_methods->larger;
    append_to_list(pairs.left_out, "; ", why_left_out(method, lacks));
  }
  return pairs;
}

bool is_as_claimed(const AcrossMethods& across, double tau) {
  switch (across.gives) {
    case Tendency::larger:
      return tau >= across.tau;
    case Tendency::smaller:
      return tau <= -across.tau;
    case Tendency::neither:
      return std::abs(tau) <= across.tau;
  }
  return false;
}

Finding finding_in(const PublishedClaim& claim, const std::vector<MethodRuns>& methods) {
  constexpr std::size_t fewest_methods = 4;
  const Pairs pairs = pairs_of(claim, methods);
  Finding finding;
  finding.remark = pairs.left_out;
  if (pairs.x.size() < fewest_methods) {
    append_to_list(finding.remark, "; ",
                   fmt::format("{} of the {} methods that it takes", pairs.x.size(), fewest_methods));
    return finding;
  }
  const double tau = kendall_tau(pairs.x, pairs.y);
  if (!std::isfinite(tau)) {
    append_to_list(finding.remark, "; ", "all methods have the same value");
    return finding;
  }
  finding.verdict = is_as_claimed(*claim.across_methods, tau) ? Verdict::held : Verdict::not_held;
  finding.ours = fmt::format("τ = {}{:.2f} over {} methods", tau < 0.0 ? "−" : "", std::abs(tau), pairs.x.size());
  return finding;
}

}  // namespace

std::vector<Finding> across_methods_findings(const PublishedClaim& claim, const Results& results) {
  std::vector<Finding> findings;
  const std::vector<ClaimCell> cells = claim_cells(results);
  for (const ClaimCell& cell : cells) {
    Finding finding = finding_in(claim, methods_in(cell, results));
    finding.data = name_among(cells, cell);
    findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace isobench
