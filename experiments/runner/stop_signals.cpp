#include "isobench/experiments/runner/stop_signals.h"

namespace isobench {

namespace {

constexpr std::array<int, 3> signals = {SIGINT, SIGTERM, SIGHUP};
volatile std::sig_atomic_t last = 0;
void remember(int signal) { last = signal; }

}  // namespace

StopSignals::StopSignals() {
  last = 0;
  struct sigaction action {};
  action.sa_handler = remember;
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &action, &before_[i]);
}

StopSignals::~StopSignals() {
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
}

bool StopSignals::arrived() { return last != 0; }

}  // namespace isobench
