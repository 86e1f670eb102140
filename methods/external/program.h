// Running another program: no shell, its output in a log, its memory watched, nothing of it left behind.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/foundation/monitor.h"

namespace isobench::external {

struct ProgramCall {
  std::vector<std::string> words;  ///< the program and its arguments
  std::filesystem::path folder;    ///< where it runs
  std::filesystem::path log;       ///< its stdout and stderr are put behind what is there
  int threads = 0;                 ///< told to it as OMP_NUM_THREADS; 0: not
};

struct ProgramEnd {
  int code = 0;    ///< exit status, where it ended by itself
  int signal = 0;  ///< the signal that ended it; 0: none
  double seconds = 0.0;
  double peak_memory_mb = 0.0;  ///< of it and what it started together, as far as it was seen; 10⁶ bytes
};

/// A name without "/" is sought in PATH, another is relative to the folder that this process runs in. Throws Error
/// where there is no such program.
std::filesystem::path find_program(const std::string& name);

/// Runs it to its end; what it started and left running is then killed. It belongs to this process's group and dies
/// with this process. Throws Error where it cannot be started, Cancelled (and kills it) where the monitor is told to
/// stop. Call from the main thread.
ProgramEnd run_program(const ProgramCall& call, Monitor& monitor);

/// The last lines that are not empty, joined by " | ", of at most the last 4 KB of a file from `begin` on.
std::string last_lines(const std::filesystem::path& file, std::uintmax_t begin, std::size_t count);

}  // namespace isobench::external
