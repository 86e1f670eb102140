// Where a result comes from: code, compiler, libraries and machine.
#pragma once

#include <map>
#include <string>

namespace isobench {

struct Environment {
  std::string version;  ///< of isobench
  std::string commit;   ///< git commit that was built; "unknown" outside a repository
  bool dirty = false;   ///< tracked files differed from that commit
  std::string compiler;
  std::string build_type;
  std::map<std::string, std::string> libraries;  ///< name → version
  std::string host;
  std::string cpu;
  int cores = 0;      ///< that this process may use
  double load = 0.0;  ///< one-minute load average
};

/// Of this program on this machine, now.
Environment environment();

}  // namespace isobench
