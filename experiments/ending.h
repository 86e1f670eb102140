// The records of runs that could not write their own.
#pragma once

#include <filesystem>
#include <optional>

#include "experiments/child.h"
#include "reports/record.h"

namespace isobench {

/// Of a child that ended without a record: by which signal or exit code, and the last lines of its log.
RunRecord without_record(const RunRequest& request, const ChildExit& exit, double seconds,
                         const std::filesystem::path& log);

/// Of a child that is beyond its limit of minutes or memory and has to be stopped; std::nullopt where it is within
/// both.
std::optional<RunRecord> beyond_limits(const RunRequest& request, const Child& child);

}  // namespace isobench
