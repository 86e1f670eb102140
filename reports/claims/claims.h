// Whether stored results bear out what a publication claims (reports/published/published_claim.h).
#pragma once

#include <string>
#include <vector>

#include "isobench/reports/published/published_claim.h"
#include "isobench/reports/tables/table.h"

namespace isobench {

struct Results;

enum class Verdict { held, not_held, not_testable };
std::string to_string(Verdict verdict);

/// A claim on one data set, on their average, or along one series of runs.
struct Finding {
  std::string data;
  Verdict verdict = Verdict::not_testable;
  std::string ours;       ///< the figures, "†" where a mesh is not closed and manifold
  std::string published;  ///< the figures that were printed; "" where none were
  std::string remark;     ///< what could not be tested, and why
};

struct ClaimResult {
  std::vector<Finding> findings;
  Verdict verdict = Verdict::not_testable;  ///< held where it held wherever it was testable, and was anywhere
  std::string summary;                      ///< "held as far as it can be tested here: no run of advancing-front"
};

/// Of several runs of one method (seeds, repeats) every one has to bear the claim out, but for a trend, which is one of
/// their medians.
ClaimResult evaluate(const PublishedClaim& claim, const Results& results);

/// "ps > af > mc", "ps at most 0.008 %", "smaller epsilon, smaller distance_mean": the rule that was tested.
std::string rule_text(const PublishedClaim& claim);

/// The same as a table, a row a finding; without rows where there are none.
Table claims_table(const Results& results);

/// All claims of the published file, for tables.md; "" where there are none.
std::string claims_section(const Results& results);

}  // namespace isobench
