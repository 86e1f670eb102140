// Runs the cells of a plan, each in a child process of its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/experiments/runner/progress.h"
#include "isobench/experiments/runner/store.h"

namespace isobench {

struct RunOptions {
  std::filesystem::path program;  ///< this executable, whose hidden verb "cell" does one run
  int jobs = 1;                   ///< children at a time; timed runs go alone whatever it is
  int threads = 0;                ///< of each child; 0: all cores
  bool force = false;             ///< also what is done already
};

struct RunSummary {
  int ok = 0;
  int skipped = 0;
  int failed = 0;     ///< and those that ran out of time or memory
  int data = 0;       ///< of `failed`, those for want of usable data
  int reused = 0;     ///< done before
  int elsewhere = 0;  ///< being done by another process, or failed at one meanwhile
  bool interrupted = false;
};

/// Runs what is not done yet, and by no other process since this one began. A crash, a hang or a memory hog costs only
/// its own run, which is recorded as such. SIGINT, SIGTERM and SIGHUP stop the children, leave nothing half-done and
/// set `interrupted`.
RunSummary run_cells(const Store& store, const std::vector<RunRequest>& cells, const RunOptions& options,
                     Console& console);

}  // namespace isobench
