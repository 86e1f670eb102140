// Methods on the same data sets, for ranks, performance profiles and the Pareto front.
#pragma once

#include <string>
#include <vector>

#include "isobench/reports/statistics/ranking.h"
#include "isobench/reports/survey/survey.h"

namespace isobench {

/// The data sets on which every surveyed() method has a run, in the order of the plan.
std::vector<std::string> shared_datasets(const RunGrid& runs);

struct SideBySide {
  std::vector<const Variant*> methods;
  std::vector<std::string> datasets;
  /// One row for each method: the value, or its inverse if a larger value is better. Infinite if the method has no
  /// closed manifold there: a fast failure must not win.
  Costs costs;
  bool empty() const { return methods.empty(); }
};

/// The surveyed() methods on their shared_datasets(), without those data sets where the value of a closed manifold was
/// not measured or not timed alike. Empty if fewer than two methods or fewer than many_datasets are left.
SideBySide side_by_side(const RunGrid& runs, const Criterion& criterion);

}  // namespace isobench
