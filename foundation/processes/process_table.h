// The processes of this machine as /proc shows them: which descends from which, and how much memory each holds.
#pragma once

#include <string>
#include <vector>

namespace isobench {

/// For example "SIGSEGV (Segmentation fault)".
std::string signal_name(int signal);

/// The processes that `pid` started, those that they started, and so on. Reads a file of every process of the machine
/// (about 10 µs each), so do not call it a hundred times a second.
std::vector<int> descendants(int pid);

/// Sends SIGKILL to every descendant of `pid` except those in `spared`, again and again until none of them runs. Does
/// not reap them: that is for their parents.
void kill_descendants(int pid, const std::vector<int>& spared = {});

/// The resident memory of a process, now and at its peak, bytes; 0 if there is no such process or it has ended.
double resident_bytes(int pid);
double peak_resident_bytes(int pid);

/// Follows how much resident memory a process and its descendants hold together. Pages that they share count for each
/// of them.
class MemoryWatch {
 public:
  explicit MemoryWatch(int pid) : pid_(pid) {}
  /// Looks again and returns the peak so far, bytes. New descendants are found every quarter of a second.
  double look();

 private:
  int pid_;
  double peak_ = 0.0;
  double next_scan_ = 0.0;
  std::vector<int> family_;
};

}  // namespace isobench
