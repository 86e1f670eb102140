#include "isobench/reports/claims/convergence.h"

#include <fmt/format.h>

#include <algorithm>

#include "isobench/reports/claims/claimed_values.h"
#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/runs/refinement.h"

namespace isobench {

namespace {

bool several_levels(const Refinement& refinement) { return refinement.levels.size() > 1; }

// The labels that the claim is about: all of them, or that of its method.
std::vector<Refinement> claimed_refinements(const PublishedClaim& claim, const Results& results) {
  std::vector<Refinement> all = refinements(results);
  if (claim.method.empty()) return all;
  const Runs runs = runs_for(results, printed_method(*results.published, claim.method));
  std::erase_if(all, [&runs](const Refinement& refinement) {
    return std::none_of(runs.begin(), runs.end(),
                        [&](const RunRecord* run) { return run->request.label == refinement.label; });
  });
  return all;
}

void add_order(const PublishedClaim& claim, const Refinement& refinement, Finding& finding) {
  const Figure error = [&claim](const RunRecord& run) {
    double sum = 0.0;
    for (const std::string& figure : claim.figures) sum += figure_value(run, figure);
    return sum;
  };
  const Order order = order_of_convergence(refinement, error);
  if (!order.untested.empty()) {
    append_to_list(finding.remark, "; ", refinement.label + " left out: " + order.untested);
    return;
  }
  const Convergence& bounds = *claim.convergence;
  const bool kept =
      (!bounds.at_least || order.value >= *bounds.at_least) && (!bounds.at_most || order.value <= *bounds.at_most);
  append_to_list(finding.ours, ", ", fmt::format("{} {:.2f}", refinement.label, order.value));
  if (!kept) finding.verdict = Verdict::not_held;
  if (kept && finding.verdict == Verdict::not_testable) finding.verdict = Verdict::held;
}

}  // namespace

std::vector<Finding> convergence_findings(const PublishedClaim& claim, const Results& results) {
  std::vector<Finding> findings;
  for (const Refinement& refinement : claimed_refinements(claim, results)) {
    // A data set with a single sizing was not meant to show an order.
    if (!several_levels(refinement)) continue;
    auto finding = std::find_if(findings.begin(), findings.end(),
                                [&refinement](const Finding& each) { return each.data == refinement.dataset; });
    if (finding == findings.end())
      finding = findings.insert(finding, Finding{refinement.dataset, Verdict::not_testable, "", "", ""});
    add_order(claim, refinement, *finding);
  }
  if (findings.empty()) return {{"–", Verdict::not_testable, "", "", "no method was run at several sizings"}};
  return findings;
}

}  // namespace isobench
