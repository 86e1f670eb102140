#include "isobench/foundation/processes/run_command.h"

#include "isobench/foundation/error.h"

namespace isobench {

CommandOutput run_command(const std::vector<std::string>& words) {
  const ChildOutput text{ChildOutput::To::text, {}};
  ChildProcess child({.words = words, .out = text, .err = text});
  const ChildExit exit = child.wait();
  return {exit, child.out(), child.err()};
}

bool run_tool(const std::vector<std::string>& words, const std::filesystem::path& folder) {
  try {
    const ChildOutput log{ChildOutput::To::new_file, folder / "log.txt"};
    return ChildProcess({.words = words, .folder = folder, .out = log}).wait().succeeded();
  } catch (const Error&) {
    return false;
  }
}

}  // namespace isobench
