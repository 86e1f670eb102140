// The record of a run whose child process may have died before it could write one.
#pragma once

#include <filesystem>
#include <optional>

#include "isobench/experiments/runner/cell_process.h"
#include "isobench/reports/record/record.h"

namespace isobench {

struct CellOutcome {
  RunRecord record;
  bool own = false;  ///< whether the child wrote the record; otherwise it was made here and says how the child failed
};

/// The outcome of a child that has ended and has left its files in `folder`: its own record, or a record of its failure
/// if its own one is missing or invalid. A record of failure names the signal or exit code and the log's last lines.
CellOutcome outcome_of(const RunRequest& request, const ChildExit& exit, double seconds,
                       const std::filesystem::path& folder);

/// The record of a child that exceeds its limit of minutes or memory and must be stopped; std::nullopt if it exceeds
/// neither.
std::optional<RunRecord> beyond_limits(const RunRequest& request, CellProcess& child);

}  // namespace isobench
