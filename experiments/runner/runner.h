// Runs the cells of a plan, each in its own child process.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/experiments/runner/progress.h"
#include "isobench/experiments/runner/store.h"

namespace isobench {

struct RunOptions {
  std::filesystem::path program;  ///< this executable; its hidden verb "cell" does one run
  int jobs = 1;                   ///< how many children run at a time; timed runs always run alone
  int threads = 0;                ///< of each child; 0: all cores
  bool force = false;             ///< repeat runs that are done
};

struct RunSummary {
  int ok = 0;
  int skipped = 0;
  int failed = 0;     ///< includes those that exceeded a limit of time or memory
  int data = 0;       ///< those of `failed` whose data are unusable
  int reused = 0;     ///< were done before
  int elsewhere = 0;  ///< another process runs them, or they failed in another process meanwhile
  bool interrupted = false;
};

/// Runs the cells that are not done yet and that no other process does meanwhile. A crash, a hang or a memory hog costs
/// only its own run, whose record says so. SIGINT, SIGTERM and SIGHUP kill the children, remove unfinished runs and set
/// `interrupted`.
RunSummary run_cells(const Store& store, const std::vector<RunRequest>& cells, const RunOptions& options,
                     Console& console);

}  // namespace isobench
