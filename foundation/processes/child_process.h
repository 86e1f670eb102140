// The one place that starts other programs. No shell is involved.
#pragma once

#include <array>
#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "isobench/foundation/processes/descriptor.h"
#include "isobench/foundation/processes/process_table.h"

namespace isobench {

/// The absolute path of a program. A name without "/" is looked up in PATH, any other name is relative to the working
/// folder of this process. Throws Error where there is no such executable file.
std::filesystem::path find_program(const std::string& name);
/// Whether find_program() finds it.
bool has_program(const std::string& name);

/// How a process ended.
struct ChildExit {
  int code = 0;    ///< exit status, if it ended by itself; -1 if somebody else collected the status
  int signal = 0;  ///< the signal that ended it; 0: none
  /// The largest resident memory of the process or of one that it waited for, 10⁶ bytes. Includes what this process
  /// held when it forked.
  double peak_memory_mb = 0.0;

  bool succeeded() const { return signal == 0 && code == 0; }
};

/// "ended by SIGSEGV (Segmentation fault)" or "ended with exit code 3".
std::string to_string(const ChildExit& exit);

/// Where an output stream of a child goes.
struct ChildOutput {
  enum class To {
    parents_stream,  ///< where the same stream of this process goes
    new_file,        ///< to a file, which is emptied first
    end_of_file,     ///< to the end of a file, which is made if it does not exist
    text             ///< to ChildProcess::out() or err()
  };
  To to = To::parents_stream;
  std::filesystem::path file;  ///< relative to the working folder of this process
};

struct ChildOptions {
  std::vector<std::string> words;     ///< the program, as find_program() takes it, and its arguments
  std::filesystem::path folder = {};  ///< where it runs; empty: in the working folder of this process
  ChildOutput out = {};
  std::optional<ChildOutput> err = {};                  ///< std::nullopt: to the same place as `out`
  std::map<std::string, std::string> environment = {};  ///< variables that are added or replaced
  bool own_group = false;                               ///< leads a process group of its own
  bool dies_with_parent = false;                        ///< SIGKILL when the thread that started it ends
  bool pipe = false;                                    ///< can write to this process through ChildProcess::pipe_number
};

/// A running program. It reads nothing (stdin is /dev/null), SIGPIPE ends it, and it inherits no descriptor that this
/// class opens except those that the options ask for.
class ChildProcess {
 public:
  /// The descriptor of the pipe in the child. A write to a full pipe fails at once: progress that nobody reads must not
  /// stop the work.
  static constexpr int pipe_number = 3;

  /// Starts the program and returns once it runs. Throws Error with the reason if it cannot be started.
  explicit ChildProcess(const ChildOptions& options);
  /// Calls kill().
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// The process number; -1 once its end is known.
  int pid() const { return pid_; }
  /// How it ended; std::nullopt while it runs. Does not wait. Later calls return the same.
  /// If the child leads a group, what is left of the group is killed when its end is noticed.
  std::optional<ChildExit> poll();
  /// The same, but waits for its end for at most that long.
  std::optional<ChildExit> wait_for(std::chrono::milliseconds time);
  /// Waits for its end, and until all processes have closed the streams that go to a text.
  ChildExit wait();
  /// Sends a signal to the child alone. Does nothing once its end is known.
  void signal(int number) const;
  /// SIGKILL to the child, its group if it leads one, and its descendants; then waits for the child. Does nothing once
  /// its end is known.
  void kill();

  /// Wall-clock seconds since the start.
  double seconds() const;
  /// The most resident memory that the child and its descendants were seen to hold together, bytes. Looks again while
  /// it runs, so call it often. See MemoryWatch.
  double peak_memory_bytes();

  /// What it wrote to the streams that go to a text; complete after wait().
  const std::string& out() const { return incoming_[0].text; }
  const std::string& err() const { return incoming_[1].text; }
  /// What came through the pipe since the last call. Does not wait.
  std::string take_from_pipe();

 private:
  struct Incoming {
    Descriptor end;
    std::string text;
  };
  void read_texts();        // what is there
  void collect(int flags);  // the exit status, as waitpid() does with these flags

  int pid_ = -1;
  bool own_group_ = false;
  Descriptor ending_;                 // becomes readable when the child ends
  std::array<Incoming, 3> incoming_;  // stdout, stderr, the pipe
  std::optional<ChildExit> exit_;
  std::optional<MemoryWatch> memory_;
  double peak_memory_bytes_ = 0.0;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace isobench
