// Runs arranged as tables show them: datasets one way, methods the other.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "isobench/reports/runs/results.h"
#include "isobench/reports/runs/spread.h"

namespace isobench {

/// One method as it was run: its label, with sizing and reference k where the same label was run with several. Seeds
/// and repeats are no variants of their own: they are the spread of one.
struct Variant {
  std::string name;
  std::string method;
  std::map<std::string, Runs> runs;  ///< by dataset
};

struct RunGrid {
  std::vector<std::string> datasets;  ///< in the order of the plan
  std::vector<Variant> variants;
  std::string timing;  ///< usual_timing(): of these runs alone are seconds compared
};

/// The sizing that was asked for: "ε 0.5, δ 0.3", "2.2 mm", "5000 vertices", with the floor where it is not the
/// default.
std::string sizing_name(const SizingRequest& sizing);

/// Of all runs but those that are aside. Points into `results`.
RunGrid arrange_runs(const Results& results);

/// The runs of a variant on a dataset, of every seed and repeat; empty where there is none.
const Runs& find_runs(const Variant& variant, const std::string& dataset);
/// One of them that stands for all in what they share: the first that is finished, else the first; nullptr where there
/// is none.
const RunRecord* find_run(const Variant& variant, const std::string& dataset);

}  // namespace isobench
