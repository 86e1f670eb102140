// The child process of one cell: a process group of its own, output in a log file, progress through a pipe.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isobench/foundation/processes/child_process.h"

namespace isobench {

/// The last progress that a child reported.
struct CellProgress {
  std::string stage;
  double fraction = -1.0;  ///< negative: unknown
};

class CellProcess {
 public:
  /// Starts a program with these words and "--progress-fd N", where N is the descriptor to write lines "fraction stage"
  /// to. Its stdout and stderr go to `log`. It dies with the calling thread, so call this from the main thread. Throws
  /// Error if it cannot be started.
  CellProcess(std::vector<std::string> words, const std::filesystem::path& log);

  /// As of ChildProcess.
  std::optional<ChildExit> poll() { return process_.poll(); }
  void kill() { process_.kill(); }
  double seconds() const { return process_.seconds(); }
  double peak_memory_gb() { return process_.peak_memory_bytes() / 1e9; }

  /// The last progress that was reported. Empties the pipe.
  const CellProgress& progress();

 private:
  ChildProcess process_;
  std::string unread_;  // from the pipe: the beginning of a line
  CellProgress progress_;
};

}  // namespace isobench
