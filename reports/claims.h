// What a publication claims, as data, and whether stored results bear it out. A claim is a [[claim]] of the file of
// published figures, and has one of three forms:
//
//   words = "…", differs = "how what we test differs from what was published"
//   figure = "radius_ratio_min"                 or a list: their sum; published = "…" is what the file calls it
//
//   order = "ps > af > mc"                      on every data set, or with data = "average" on the mean over them;
//   about = 0.03, much = 1.25                   "~" within so much, relative; ">>" and "<<" by at least this factor
//
//   method = "ps", at_most = 0.008              or at_least; on every data set
//
//   method = "ps", smaller = "epsilon", gives = "smaller" or "larger"
//                                               from run to run that differ in epsilon (or delta) alone
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "datasets/toml.h"
#include "reports/table.h"

namespace isobench {

struct Published;
struct Results;

enum class Relation { about, below, above, far_below, far_above };

struct PublishedClaim {
  std::string words;
  std::string differs;
  std::vector<std::string> figures;  ///< summed
  std::string quantity;              ///< as the published file calls it; "" where it gives none

  std::vector<std::string> order;   ///< methods as printed, empty where the claim is of another form
  std::vector<Relation> relations;  ///< between each of them and the next
  double about = 0.0;
  double much = 0.0;
  bool average = false;

  std::string method;  ///< as printed, for the other two forms
  std::optional<double> at_most;
  std::optional<double> at_least;

  std::string smaller;  ///< "epsilon" or "delta"
  bool gives_larger = false;
};

/// Throws UsageError with the place for an unknown figure, method or key, a form that is not whole, or two at once.
PublishedClaim claim_from(const TomlValue& table, const Published& published);

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
