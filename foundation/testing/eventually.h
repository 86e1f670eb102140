// For tests of what other processes do.
#pragma once

#include <chrono>
#include <functional>
#include <thread>

namespace isobench {

/// Waits until the condition holds and returns true. Gives up and returns false after a minute, which is far longer
/// than a run on a phantom takes, even under a sanitizer.
inline bool eventually(const std::function<bool()>& condition,
                       std::chrono::steady_clock::duration patience = std::chrono::minutes(1)) {
  const auto start = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - start < patience) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return condition();
}

}  // namespace isobench
