// What runs on many data sets say together: how often the meshes of a method pass each check, the values of a figure,
// and the worst case. A data set counts once, whatever the number of its seeds and repeats.
#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "isobench/reports/runs/checks.h"
#include "isobench/reports/runs/run_grid.h"
#include "isobench/reports/survey/criteria.h"

namespace isobench {

/// The methods with many_datasets or more.
std::vector<const Variant*> surveyed(const RunGrid& runs);

/// The data sets of a family on which a method has a run, in the order of the plan. "" stands for all families.
std::vector<std::string> datasets_of(const RunGrid& runs, const Variant& variant, const std::string& family = "");

/// How many data sets pass a check. One without a mesh does not pass. One that was not measured counts neither way.
struct PassCount {
  std::size_t passed = 0;
  std::size_t asked = 0;                ///< passed or not
  std::size_t not_measured = 0;         ///< because a figure was not measured, or is unknown to an old record
  std::vector<std::string> not_passed;  ///< these data sets, in the order of the plan
};

/// One method over the data sets of a family, or over all.
struct Tally {
  std::size_t datasets = 0;            ///< on which the method has a run
  std::map<Status, std::size_t> ends;  ///< how many data sets ended so; the first run that is not ok decides
  std::vector<PassCount> checks;       ///< one for each of checks(); a data set passes if all its runs do
  PassCount sound;                     ///< closed manifold, right topology and no self-intersections
};
Tally tally(const RunGrid& runs, const Variant& variant, const std::string& family = "");

/// The value of a data set: the median over the counted runs (counted_runs()) and, for seconds, over those that were
/// timed alike. NaN if there is none.
double value_on(const RunGrid& runs, const Variant& variant, const std::string& dataset, const Criterion& criterion);
/// The values that are known, in the order of the plan.
std::vector<double> values_over(const RunGrid& runs, const Variant& variant, const Criterion& criterion,
                                const std::string& family = "");

/// The worst value of all finished runs, open meshes included; of equally bad ones the first.
struct WorstCase {
  const RunRecord* run = nullptr;  ///< nullptr if the figure was measured nowhere
  double value = std::numeric_limits<double>::quiet_NaN();
};
WorstCase worst_case(const RunGrid& runs, const Variant& variant, const Criterion& criterion,
                     const std::string& family = "");

}  // namespace isobench
