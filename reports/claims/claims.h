// Tests the claims of a publication (reports/published/published_claim.h) on stored results.
#pragma once

#include <string>
#include <vector>

#include "isobench/reports/published/published_claim.h"
#include "isobench/reports/tables/table.h"

namespace isobench {

struct Results;

enum class Verdict { held, not_held, not_testable };
std::string to_string(Verdict verdict);

/// The result of a claim on one data set, on the average of all, or for one series of runs.
struct Finding {
  std::string data;  ///< the data set, "average of 4", or what all runs of a series share
  Verdict verdict = Verdict::not_testable;
  std::string ours;       ///< our values; "†" marks a mesh that is not closed and manifold
  std::string published;  ///< the values that were printed; "" where none were
  std::string remark;     ///< what could not be tested, and why
};

struct ClaimResult {
  std::vector<Finding> findings;
  Verdict verdict = Verdict::not_testable;  ///< held: there is a finding that held, and none that did not hold
  std::string summary;                      ///< "held as far as it could be tested (advancing-front was not run)"
};

/// Tests a claim. Where one method has several seeds or repeats, an order or a bound must hold for every single run; a
/// trend must hold for the medians. Orders and bounds leave out the runs that are aside (RunRequest::aside); trends
/// look at them, too, because a sweep of a parameter often stands beside the tables that compare.
ClaimResult evaluate(const PublishedClaim& claim, const Results& results);

/// The rule that is tested: "radius_ratio_min: ps > af > mc, on each data set".
std::string rule_text(const PublishedClaim& claim);

/// "Names in the publication: ps is our particles-2007 or particles, …"; "" where all names are ours.
std::string printed_names(const Published& published);

/// All claims as one table, a row for each finding; no rows where nothing is claimed.
Table claims_table(const Results& results);

/// All claims of the published file, for tables.md; "" where there are none.
std::string claims_section(const Results& results);

}  // namespace isobench
