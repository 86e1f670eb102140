#include "experiments/fault.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "experiments/plan.h"

namespace isobench {

void inject_fault(const RunRequest& request) {
  const char* variable = std::getenv("ISOBENCH_TEST_FAULT");
  if (variable == nullptr) return;
  const std::string fault = variable;
  const std::size_t colon = fault.find(':');
  if (colon == std::string::npos || !selected(request, fault.substr(colon + 1))) return;
  const std::string kind = fault.substr(0, colon);
  if (kind == "crash") {
    std::signal(SIGSEGV, SIG_DFL);
    std::raise(SIGSEGV);
  }
  std::vector<std::vector<char>> hoard;
  while (kind == "hang" || kind == "memory") {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (kind == "memory") hoard.emplace_back(std::size_t{16} << 20U, 'x');
  }
}

}  // namespace isobench
