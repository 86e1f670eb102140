// Notices the signals that ask a program to end, so that it can finish or undo what it began.
#pragma once

#include <array>
#include <csignal>

namespace isobench {

/// During its lifetime SIGINT, SIGTERM and SIGHUP only set `arrived()`. Use one object at a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// Whether one of these signals arrived since the latest object was made.
  static bool arrived();

 private:
  std::array<struct sigaction, 3> before_{};
};

}  // namespace isobench
