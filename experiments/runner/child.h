// A child process of its own process group, with its output in a file, its progress on a pipe and its memory watched.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isobench/foundation/processes.h"

namespace isobench {

/// How a child ended.
struct ChildExit {
  int code = 0;    ///< exit status, where it ended by itself
  int signal = 0;  ///< the signal that ended it; 0: none
};

/// Where a child says it is.
struct ChildProgress {
  std::string stage;
  double fraction = -1.0;  ///< negative: unknown
};

class Child {
 public:
  /// Starts `arguments` (the first is the program's path) with stdout and stderr in `log` and with
  /// "--progress-fd N" appended, N being the pipe to write "fraction stage" lines to. The child dies with this process.
  /// Call from the main thread. Throws Error if the process cannot be started.
  Child(std::vector<std::string> arguments, const std::filesystem::path& log);
  /// Kills and reaps it if it still runs.
  ~Child();
  Child(Child&& other) noexcept;
  Child& operator=(Child&&) = delete;
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// The exit of a child that has ended; reaps it. Does not wait.
  std::optional<ChildExit> poll();
  /// SIGKILL to it, its whole process group and all that it started, and waits for it.
  void kill();
  double seconds() const;  ///< since it was started, wall
  /// Of resident memory so far, its own and that of what it started, 10⁹ bytes; 0 once it has ended.
  double peak_memory_gb();
  const ChildProgress& progress();

 private:
  int pid_ = -1;
  int pipe_ = -1;
  std::string buffer_;
  ChildProgress progress_;
  std::optional<MemoryWatch> memory_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace isobench
