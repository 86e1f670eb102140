// How `run` and `report` write a report and print it.
#pragma once

#include <filesystem>

#include "isobench/experiments/command_line/verbs.h"
#include "isobench/experiments/runner/progress.h"
#include "isobench/experiments/runner/store.h"

namespace isobench {

/// Writes the parts of a results folder's report that `common` asks for, and shows on the console that it does so.
Report make_report(const std::filesystem::path& folder, const CommonArguments& common, Console& console);

/// Prints the tables on stdout.
void print_tables(const Report& report);

/// Prints on the console which parts are missing and why, and the paths of the files that were written.
void print_written_files(const std::filesystem::path& folder, const Report& report, Console& console);

}  // namespace isobench
