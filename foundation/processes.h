// Processes of this machine as /proc shows them: who descends from whom and what they take. Linux only.
#pragma once

#include <string>
#include <vector>

namespace isobench {

/// "SIGSEGV (segmentation fault)" and the like.
std::string signal_name(int signal);

/// The processes that `pid` started, those that they started, and so on. Costs a look at every process there is (about
/// 10 µs each), so do not ask a hundred times a second.
std::vector<int> descendants(int pid);

/// SIGKILL to every descendant of `pid` but those in `spared`, again until none is left that runs. What they leave to
/// be waited for stays with their parents.
void kill_descendants(int pid, const std::vector<int>& spared = {});

/// Memory that a process holds now, and the most that it held so far, bytes; 0 where there is no such process or it has
/// ended.
double resident_bytes(int pid);
double peak_resident_bytes(int pid);

/// The most memory that a process and its descendants were seen to hold together. Shared pages count for each of them.
class MemoryWatch {
 public:
  explicit MemoryWatch(int pid) : pid_(pid) {}
  /// Looks again; at the descendants every quarter of a second only. Returns the peak, bytes.
  double look();

 private:
  int pid_;
  double peak_ = 0.0;
  double next_scan_ = 0.0;
  std::vector<int> family_;
};

}  // namespace isobench
