// Claims as a section of tables.md.
#include <fmt/format.h>

#include <algorithm>

#include "isobench/reports/claims/claims.h"
#include "isobench/reports/runs/results.h"
#include "isobench/reports/tables/table_parts.h"

namespace isobench {

namespace {

std::string or_dash(const std::string& text) { return text.empty() ? "–" : text; }

std::string claim_text(std::size_t number, const PublishedClaim& claim, const ClaimResult& result) {
  // Where there is nothing to judge, the summary says why.
  MarkdownTable table({"Data", "Verdict", "Ours", "Published"});
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

Table claims_table(const Results& results) {
  Table table;
  if (!results.published) return table;
  table.title = "Claims of " + results.published->short_source;
  table.header = {"Claim", "Data", "Verdict", "Ours", "Published", "Tested"};
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
  std::size_t number = 0;
  for (const PublishedClaim& claim : results.published->claims) {
    text += claim_text(++number, claim, evaluate(claim, results));
  }
  return text;
}

}  // namespace isobench
