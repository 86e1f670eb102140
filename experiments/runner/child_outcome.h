// How a run ended, where it may not have been able to write that down itself.
#pragma once

#include <filesystem>
#include <optional>

#include "isobench/experiments/runner/child.h"
#include "isobench/reports/record/record.h"

namespace isobench {

struct ChildOutcome {
  RunRecord record;
  bool own = false;  ///< the child's; else one that says how it failed
};

/// What to keep of a child that came to its end, with what it left in `folder`: its own record or, where that is
/// missing or nonsense, one with the signal, the exit code and the last lines of its log, or with what was wrong.
ChildOutcome outcome_of(const RunRequest& request, const ChildExit& exit, double seconds,
                        const std::filesystem::path& folder);

/// Of a child that is beyond its limit of minutes or memory and has to be stopped; std::nullopt where it is within
/// both.
std::optional<RunRecord> beyond_limits(const RunRequest& request, Child& child);

}  // namespace isobench
