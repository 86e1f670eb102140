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
  std::string data;  ///< the data set, "average of 4", or the name of a series of runs
  Verdict verdict = Verdict::not_testable;
  std::string ours;       ///< our values; "†" marks a mesh that is not closed and manifold
  std::string published;  ///< the printed values; "" if there are none
  std::string remark;     ///< what could not be tested, and why
};

struct ClaimResult {
  std::vector<Finding> findings;
  Verdict verdict = Verdict::not_testable;  ///< held: at least one finding held, and none did not hold
  std::string summary;                      ///< "held as far as it could be tested (advancing-front was not run)"
};

/// Tests a claim. If a method has several seeds or repeats, an order or a bound must hold for every single run, and a
/// trend must hold for the medians. Orders and bounds leave out the runs that are aside (RunRequest::aside). Trends
/// include them, because sweeps of a parameter are often kept out of the tables in this way.
ClaimResult evaluate(const PublishedClaim& claim, const Results& results);

/// The rule that is tested: "radius_ratio_min: ps > af > mc, on each data set".
std::string rule_text(const PublishedClaim& claim);

/// "Names in the publication: ps is our particles-2007 or particles, …"; "" if all names are ours.
std::string printed_names(const Published& published);

/// All claims as one table, a row for each finding; no rows if there are no claims.
Table claims_table(const Results& results);

/// All claims of the published file, for tables.md; "" if there are none.
std::string claims_section(const Results& results);

}  // namespace isobench
