// Runs arranged as the tables show them: methods in one direction, data sets in the other.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "isobench/reports/runs/results.h"
#include "isobench/reports/runs/spread.h"

namespace isobench {

/// One method as it was run, a row of most tables. Runs with different seeds or repeats belong to the same variant.
struct Variant {
  std::string name;  ///< the label, with the sizing if one label has several
  std::string method;
  std::map<std::string, Runs> runs;  ///< by dataset
};

struct RunGrid {
  std::vector<std::string> datasets;  ///< in the order of the plan
  std::vector<Variant> variants;
  std::string timing;  ///< usual_timing(): seconds are compared only between runs with this timing
};

/// The requested sizing: "ε 0.5, δ 0.3", "2.2 mm", "5000 vertices"; with the floor if it is not the default.
std::string sizing_name(const SizingRequest& sizing);

/// Arranges all runs except those that are aside (RunRequest::aside). The grid points into `results`.
RunGrid arrange_runs(const Results& results);

/// All runs of a variant on a dataset, over seeds and repeats; empty if there is none.
const Runs& find_runs(const Variant& variant, const std::string& dataset);
/// One of these runs, for what all of them share: the first finished one, else the first; nullptr if there is none.
const RunRecord* find_run(const Variant& variant, const std::string& dataset);

}  // namespace isobench
