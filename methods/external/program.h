// Runs an external program to its end: its output goes to a log, its memory is watched, and nothing that it started
// survives it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/foundation/monitor.h"
#include "isobench/foundation/processes/child_process.h"

namespace isobench::external {

struct ProgramCall {
  std::vector<std::string> words;  ///< the program and its arguments
  std::filesystem::path folder;    ///< where it runs
  std::filesystem::path log;       ///< its stdout and stderr are appended to this file
  int threads = 0;                 ///< OMP_NUM_THREADS of the program; 0: as in this process
};

struct ProgramEnd {
  ChildExit exit;
  double seconds = 0.0;
  double peak_memory_mb = 0.0;  ///< largest sum seen over the program and its descendants, 10⁶ bytes
};

/// Runs the program and waits for its end; then kills whatever it left running. The program belongs to the process
/// group of this process and dies with the calling thread, so call this from the main thread. Throws Error if the
/// program cannot be started. When the monitor is cancelled, kills the program and throws Cancelled.
ProgramEnd run_program(const ProgramCall& call, Monitor& monitor);

}  // namespace isobench::external
