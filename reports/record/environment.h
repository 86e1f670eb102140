// Where a result comes from: code, compiler, libraries and machine.
#pragma once

#include <map>
#include <string>

#include "isobench/reports/record/shared_value.h"

namespace isobench {

using LibraryVersions = std::map<std::string, std::string>;  ///< name → version

struct Environment {
  std::string version;  ///< of isobench
  std::string commit;   ///< git commit that was built; "unknown" outside a repository
  bool dirty = false;   ///< tracked files differed from that commit
  std::string compiler;
  std::string build_type;
  SharedValue<LibraryVersions> libraries;
  std::string host;
  std::string cpu;
  int cores = 0;           ///< that this process may use
  double load = 0.0;       ///< one-minute load average
  bool exclusive = false;  ///< a scheduler gave the whole machine to this run alone (ISOBENCH_EXCLUSIVE is set)
  std::string job;         ///< slurm_task()
};

std::string host_name();
/// "123_4" in a task of a Slurm job array, "123" in another job, "" elsewhere.
std::string slurm_task();
/// UTC, ISO 8601, to the second.
std::string utc_now();

/// The environment of this process, now.
Environment environment();

}  // namespace isobench
