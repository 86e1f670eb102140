// Which runs' seconds may stand side by side.
#pragma once

#include <string>
#include <vector>

#include "reports/arrangement.h"

namespace isobench {

/// How a run was timed, in words: processor, cores, threads, and whether a scheduler gave it the machine alone. Seconds
/// of runs that differ in it do not compare.
std::string timing_of(const RunRecord& record);

/// What most of the finished runs have in common; the first of those that as many have. "" where nothing is finished.
std::string usual_timing(const Arrangement& runs);

/// The runs that were timed so.
Runs timed_so(const Runs& runs, const std::string& timing);

/// Every way in which a finished run was timed.
std::vector<std::string> all_timings(const Arrangement& runs);

}  // namespace isobench
