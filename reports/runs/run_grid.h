// Runs arranged as the tables show them: methods in one direction, data sets in the other.
#pragma once

#include <cstddef>
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
  std::vector<std::string> datasets;             ///< in the order of the plan
  std::map<std::string, std::string> family_of;  ///< of each data set that is a member of one
  std::vector<Variant> variants;
  std::string timing;  ///< usual_timing(): seconds are compared only between runs with this timing
};

/// The requested sizing: "ε 0.5, δ 0.3", "2.2 mm", "5000 vertices"; with the floor if it is not the default.
std::string sizing_name(const SizingRequest& sizing);

/// With this many data sets for one method, reports sum up over the data sets, and what they show of single ones comes
/// last. Fewer are looked at one by one.
inline constexpr std::size_t many_datasets = 8;
bool has_many_datasets(const RunGrid& runs);

/// The families in the order of the plan; empty if no data set is of one.
std::vector<std::string> families_of(const RunGrid& runs);

/// Arranges all runs except those that are aside (RunRequest::aside). The grid points into `results`.
RunGrid arrange_runs(const Results& results);

/// All runs of a variant on a dataset, over seeds and repeats; empty if there is none.
const Runs& find_runs(const Variant& variant, const std::string& dataset);
/// The data set that a reader is shown first: the first of those on which the most methods have a closed, manifold
/// mesh.
/// "" if there is no such mesh.
std::string opening_dataset(const RunGrid& runs);
/// One of these runs, for what all of them share: the first finished one, else the first; nullptr if there is none.
const RunRecord* find_run(const Variant& variant, const std::string& dataset);

}  // namespace isobench
