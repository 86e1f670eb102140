// What `run` and `report` print of a report.
#pragma once

#include <filesystem>

#include "isobench/experiments/command_line/verbs.h"
#include "isobench/experiments/runner/progress.h"
#include "isobench/experiments/runner/store.h"

namespace isobench {

/// Writes the report of a results folder, as much of it as `common` asks for, and shows on the console that it does.
Report make_report(const std::filesystem::path& folder, const CommonArguments& common, Console& console);

/// The tables, on stdout.
void print_tables(const Report& report);

/// Which parts are missing and why, and the paths of the files that were written, on the console.
void print_written_files(const std::filesystem::path& folder, const Report& report, Console& console);

}  // namespace isobench
