// Claims in words and as tables.
#include <fmt/format.h>

#include <algorithm>

#include "isobench/reports/claims/claimed_values.h"
#include "isobench/reports/claims/claims.h"
#include "isobench/reports/runs/results.h"
#include "isobench/reports/tables/table_parts.h"

namespace isobench {

namespace {

std::string or_dash(const std::string& text) { return text.empty() ? "–" : text; }

std::string order_rule(const PublishedClaim& claim) {
  std::string text = claim.order.front();
  for (std::size_t i = 0; i < claim.relations.size(); ++i)
    text += " " + to_string(claim.relations[i]) + " " + claim.order[i + 1];
  text += claim.average ? ", mean over the data sets" : ", on each data set";
  if (claim.about > 0.0) text += fmt::format("; ~ means within {} %", 100.0 * claim.about);
  if (claim.much > 0.0) text += fmt::format("; >> and << mean by a factor of at least {}", claim.much);
  return text;
}

std::string bound_rule(const PublishedClaim& claim) {
  std::string text = claim.method + " has";
  if (claim.at_least) text += fmt::format(" at least {}", *claim.at_least);
  if (claim.at_most) text += fmt::format("{} at most {}", claim.at_least ? " and" : "", *claim.at_most);
  return text + ", on each data set";
}

std::string trend_rule(const PublishedClaim& claim) {
  return fmt::format("for {} the value gets {} if only {} gets smaller; medians over the seeds", claim.method,
                     claim.gives_larger ? "larger" : "smaller", claim.smaller);
}

std::string across_methods_rule(const AcrossMethods& across) {
  if (across.gives == Tendency::neither) {
    return fmt::format("over the methods on each data set, it does not depend on {}: Kendall's τ is between −{} and {}",
                       across.larger, across.tau, across.tau);
  }
  const bool rises = across.gives == Tendency::larger;
  return fmt::format("over the methods on each data set, it is {} where {} is larger: Kendall's τ is at {} {}{}",
                     rises ? "larger" : "smaller", across.larger, rises ? "least" : "most", rises ? "" : "−",
                     across.tau);
}

std::string convergence_rule(const PublishedClaim& claim) {
  std::string text = fmt::format("{} falls with h at an order of",
                                 claim.method.empty() ? "for each method it" : "for " + claim.method + " it");
  const Convergence& bounds = *claim.convergence;
  if (bounds.at_least) text += fmt::format(" at least {}", *bounds.at_least);
  if (bounds.at_most) text += fmt::format("{} at most {}", bounds.at_least ? " and" : "", *bounds.at_most);
  return text + ", on each data set with three sizings or more";
}

std::string claim_text(std::size_t number, const PublishedClaim& claim, const ClaimResult& result) {
  MarkdownTable table({"Data", "Verdict", "Measured", "Published"});
  // A table that only repeats "not testable" is left out: the summary gives the reason.
  const bool empty = std::all_of(result.findings.begin(), result.findings.end(), [](const Finding& finding) {
    return finding.verdict == Verdict::not_testable || (finding.ours + finding.published).empty();
  });
  for (const Finding& finding : result.findings) {
    table.add({finding.data, to_string(finding.verdict), or_dash(finding.ours), or_dash(finding.published)});
  }
  std::string text = fmt::format("### {}. {}\n\n**{}**\n\n", number, claim.words, result.summary);
  if (!empty) text += table.text() + "\n";
  text += fmt::format("Tested: {}.\n", rule_text(claim));
  if (!claim.differs.empty()) text += fmt::format("What differs: {}\n", claim.differs);
  return text + "\n";
}

}  // namespace

std::string rule_text(const PublishedClaim& claim) {
  std::string rule = bound_rule(claim);
  if (!claim.order.empty()) rule = order_rule(claim);
  if (!claim.smaller.empty()) rule = trend_rule(claim);
  if (claim.across_methods) rule = across_methods_rule(*claim.across_methods);
  if (claim.convergence) rule = convergence_rule(claim);
  return fmt::format("{}: {}", fmt::join(claim.figures, " + "), rule);
}

std::string printed_names(const Published& published) {
  std::string text;
  for (const PublishedMethod& method : published.methods) {
    const std::string ours = fmt::format("{}", fmt::join(methods_for(method), " or "));
    if (method.printed != ours) append_to_list(text, ", ", method.printed + " is our " + ours);
  }
  return text.empty() ? "" : "Names in the publication: " + text + ".";
}

Table claims_table(const Results& results) {
  Table table;
  if (!results.published) return table;
  table.title = "Claims of " + results.published->short_source;
  table.header = {"Claim", "Data", "Verdict", "Measured", "Published", "Tested"};
  table.label_columns = 2;
  std::size_t number = 0;
  for (const PublishedClaim& claim : results.published->claims) {
    const ClaimResult result = evaluate(claim, results);
    ++number;
    table.remarks.push_back(fmt::format("{}. {} {}.{}", number, claim.words, result.summary,
                                        claim.differs.empty() ? "" : " What differs: " + claim.differs));
    for (const Finding& finding : result.findings) {
      table.rows.push_back({fmt::format("{}", number), finding.data, to_string(finding.verdict), or_dash(finding.ours),
                            or_dash(finding.published), rule_text(claim)});
    }
  }
  return table;
}

std::string claims_section(const Results& results) {
  if (!results.published || results.published->claims.empty()) return "";
  std::string text = heading("Claims of " + results.published->short_source);
  if (const std::string names = printed_names(*results.published); !names.empty()) text += names + "\n\n";
  std::size_t number = 0;
  for (const PublishedClaim& claim : results.published->claims) {
    text += claim_text(++number, claim, evaluate(claim, results));
  }
  return text;
}

}  // namespace isobench
