// Short ways to run a program to its end.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isobench/foundation/processes/child_process.h"

namespace isobench {

/// How a program ended and what it printed.
struct CommandOutput {
  ChildExit exit;
  std::string out;
  std::string err;
};
/// Runs a program with these arguments. Throws Error if it cannot be started.
CommandOutput run_command(const std::vector<std::string>& words);

/// Runs a program in `folder`; what it prints goes to log.txt there. Returns whether it could be started and ended with
/// exit code 0.
bool run_tool(const std::vector<std::string>& words, const std::filesystem::path& folder);

}  // namespace isobench
