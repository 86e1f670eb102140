// Which runs' seconds may stand side by side.
#pragma once

#include <string>

#include "isobench/reports/runs/run_grid.h"

namespace isobench {

/// How a run was timed, in words: processor, cores, threads, and whether a scheduler gave it the machine alone. Seconds
/// of runs that differ in it do not compare.
std::string timing_of(const RunRecord& record);

/// What most of the finished runs have in common; the first of those that as many have. "" where nothing is finished.
std::string usual_timing(const RunGrid& runs);

/// The runs that were timed so.
Runs timed_so(const Runs& runs, const std::string& timing);

/// The sentence for under a table with seconds: among which runs they are compared, and which are left out; "" where
/// all runs were timed alike.
std::string timing_remark(const RunGrid& runs);

}  // namespace isobench
