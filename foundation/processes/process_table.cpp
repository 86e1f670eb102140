#include "isobench/foundation/processes/process_table.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <thread>

namespace isobench {

namespace {

// The parent of a process; 0 if there is no such process or it has ended and waits to be reaped.
int parent_of(int pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string line;
  std::getline(file, line);
  // "pid (name) state parent …"; the name may contain blanks and brackets.
  const std::size_t name_end = line.rfind(')');
  if (name_end == std::string::npos || line.size() < name_end + 5) return 0;
  const char state = line[name_end + 2];
  if (state == 'Z' || state == 'X') return 0;
  int parent = 0;
  std::from_chars(line.data() + name_end + 4, line.data() + line.size(), parent);
  return parent;
}

std::map<int, std::vector<int>> children_by_parent() {
  std::map<int, std::vector<int>> children;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", error)) {
    const std::string name = entry.path().filename().string();
    int pid = 0;
    const auto [end, problem] = std::from_chars(name.data(), name.data() + name.size(), pid);
    if (problem != std::errc() || end != name.data() + name.size()) continue;
    if (const int parent = parent_of(pid); parent > 0) children[parent].push_back(pid);
  }
  return children;
}

double status_bytes(int pid, const char* key) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(key)) return std::stod(line.substr(std::strlen(key))) * 1024.0;
  }
  return 0.0;
}

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

std::string signal_name(int signal) {
  const char* abbreviation = sigabbrev_np(signal);
  const char* description = sigdescr_np(signal);
  if (abbreviation == nullptr) return "signal " + std::to_string(signal);
  return std::string("SIG") + abbreviation + (description == nullptr ? "" : std::string(" (") + description + ")");
}

std::vector<int> descendants(int pid) {
  const std::map<int, std::vector<int>> children = children_by_parent();
  std::vector<int> found = {pid};
  for (std::size_t n = 0; n < found.size(); ++n) {
    if (const auto of = children.find(found[n]); of != children.end()) {
      found.insert(found.end(), of->second.begin(), of->second.end());
    }
  }
  found.erase(found.begin());
  return found;
}

void kill_descendants(int pid, const std::vector<int>& spared) {
  // A descendant may start another one meanwhile, hence the loop. It ends even if a process cannot be killed.
  for (int tries = 0; tries < 100; ++tries) {
    std::vector<int> family = descendants(pid);
    std::erase_if(family, [&spared](int one) { return std::find(spared.begin(), spared.end(), one) != spared.end(); });
    if (family.empty()) return;
    for (const int member : family) ::kill(member, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

double resident_bytes(int pid) { return status_bytes(pid, "VmRSS:"); }
double peak_resident_bytes(int pid) { return status_bytes(pid, "VmHWM:"); }

double MemoryWatch::look() {
  if (const double time = now(); time >= next_scan_) {
    family_ = descendants(pid_);
    next_scan_ = time + 0.25;
  }
  double together = resident_bytes(pid_);
  for (const int one : family_) together += resident_bytes(one);
  peak_ = std::max({peak_, peak_resident_bytes(pid_), together});
  return peak_;
}

}  // namespace isobench
