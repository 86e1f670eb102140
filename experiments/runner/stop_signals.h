// The signals that end a session, noticed in the place of being obeyed, so that nothing is left half-done.
#pragma once

#include <array>
#include <csignal>

namespace isobench {

/// While it lives, SIGINT, SIGTERM and SIGHUP only set `arrived()`. One at a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// Whether one came since the last of these objects was made.
  static bool arrived();

 private:
  std::array<struct sigaction, 3> before_{};
};

}  // namespace isobench
