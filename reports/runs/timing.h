// Which runs' seconds may be compared.
#pragma once

#include <string>

#include "isobench/reports/runs/run_grid.h"

namespace isobench {

/// How a run was timed, in words: processor, cores, threads, and whether nothing else ran on the machine. Runs that
/// differ in this must not be compared by their seconds.
std::string timing_of(const RunRecord& record);

/// The most frequent timing_of() of the finished runs; of equally frequent ones the first. "" if no run is finished.
std::string usual_timing(const RunGrid& runs);

/// The runs with this timing_of().
Runs runs_with_timing(const Runs& runs, const std::string& timing);

/// A sentence under a table with seconds: which runs are compared and which are left out; "" if all runs were timed
/// alike.
std::string timing_remark(const RunGrid& runs);

}  // namespace isobench
