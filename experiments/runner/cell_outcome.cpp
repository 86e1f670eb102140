#include "isobench/experiments/runner/cell_outcome.h"

#include <fmt/format.h>

#include "isobench/experiments/plan/plan.h"
#include "isobench/experiments/runner/cell.h"
#include "isobench/foundation/files/whole_files.h"

namespace isobench {

namespace {

RunRecord failure(const RunRequest& request, Status status, const std::string& reason, double seconds) {
  RunRecord record = begin_record(request, 0);
  record.status = status;
  record.reason = reason;
  record.seconds_total = seconds;
  return record;
}

// The record that a child wrote; std::nullopt with the reason if it is invalid. The mesh is not read, because a damaged
// file could then harm other runs. Whoever reads it later checks it.
std::optional<RunRecord> recorded_by_child(const RunRequest& request, const std::filesystem::path& folder,
                                           std::string& reason) {
  try {
    RunRecord record = record_from_json(read_text(folder / "run.json"), "run.json");
    std::error_code none;
    const bool meshed = std::filesystem::is_regular_file(folder / "mesh.vtp") &&
                        std::filesystem::file_size(folder / "mesh.vtp", none) > 0;
    if (result_key(record.request) != result_key(request)) {
      reason = "left the record of another run (" + record.request.run + ")";
    } else if (record.status == Status::ok && !meshed) {
      reason = "recorded as ok without a mesh";
    } else {
      return record;
    }
  } catch (const Error&) {
    reason = "left a run.json that is no run record";
  }
  return std::nullopt;
}

std::string exit_reason(const ChildExit& exit, const std::filesystem::path& log) {
  const std::string how = to_string(exit) + (exit.signal != 0 ? "" : " and no record");
  const std::string tail = last_lines(log, 3);
  return tail.empty() ? how : how + "; its log ends: " + tail;
}

}  // namespace

CellOutcome outcome_of(const RunRequest& request, const ChildExit& exit, double seconds,
                       const std::filesystem::path& folder) {
  std::string reason;
  if (exit.signal != 0 || !std::filesystem::is_regular_file(folder / "run.json")) {
    reason = exit_reason(exit, folder / "log.txt");
  } else if (std::optional<RunRecord> record = recorded_by_child(request, folder, reason)) {
    return {std::move(*record), true};
  }
  return {failure(request, Status::failed, reason, seconds), false};
}

std::optional<RunRecord> beyond_limits(const RunRequest& request, CellProcess& child) {
  const double seconds = child.seconds();
  if (request.limit_minutes && seconds > 60.0 * *request.limit_minutes) {
    return failure(request, Status::timeout, fmt::format("not finished after {} minutes", *request.limit_minutes),
                   seconds);
  }
  if (request.limit_memory_gb && child.peak_memory_gb() > *request.limit_memory_gb) {
    return failure(request, Status::out_of_memory, fmt::format("needed more than {} GB", *request.limit_memory_gb),
                   seconds);
  }
  return std::nullopt;
}

}  // namespace isobench
