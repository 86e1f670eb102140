#include "isobench/foundation/processes/available_memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

namespace isobench {

namespace {

namespace fs = std::filesystem;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The number in a file; none where there is no such file, or a word such as "max".
std::optional<double> number_in(const fs::path& path) {
  std::ifstream file(path);
  double number = 0.0;
  if (file >> number) return number;
  return std::nullopt;
}

/// The number after a word at the beginning of a line.
std::optional<double> number_after(const std::string& word, const fs::path& path) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string first;
    double number = 0.0;
    if (words >> first >> number && first == word) return number;
  }
  return std::nullopt;
}

/// What is left of the limit of one group. The kernel takes pages of files that were read long ago away before it
/// refuses memory, so they count as free.
double left_in(const fs::path& folder, const char* limit_file, const char* used_file, const char* cache) {
  const auto limit = number_in(folder / limit_file);
  const auto used = number_in(folder / used_file);
  if (!limit || !used) return infinite;
  return std::max(0.0, *limit - *used + number_after(cache, folder / "memory.stat").value_or(0.0));
}

/// The least that is left in a group and the groups that it is in.
double left_in_all(const fs::path& mount, const fs::path& group, const char* limit_file, const char* used_file,
                   const char* cache) {
  double least = left_in(mount, limit_file, used_file, cache);
  fs::path folder = mount;
  for (const fs::path& part : group.relative_path()) {
    folder /= part;
    least = std::min(least, left_in(folder, limit_file, used_file, cache));
  }
  return least;
}

}  // namespace

double available_memory(const fs::path& root) {
  double least = infinite;
  if (const auto kibibytes = number_after("MemAvailable:", root / "proc/meminfo")) least = *kibibytes * 1024.0;
  // Lines such as "0::/user.slice" (version 2) and "4:cpu,memory:/jobs" (version 1).
  std::ifstream groups(root / "proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const fs::path group = line.substr(second + 1);
    const fs::path mount = root / "sys/fs/cgroup";
    if (controllers == ",,")
      least = std::min(least, left_in_all(mount, group, "memory.max", "memory.current", "inactive_file"));
    if (controllers.find(",memory,") != std::string::npos) {
      least = std::min(least, left_in_all(mount / "memory", group, "memory.limit_in_bytes", "memory.usage_in_bytes",
                                          "total_inactive_file"));
    }
  }
  return least;
}

}  // namespace isobench
