#include "isobench/reports/record/environment.h"

#include <sched.h>
#include <unistd.h>

#include <cstdlib>
#include <ctime>
#include <fstream>

#include "isobench/reports/record/git_commit.h"

namespace isobench {

namespace {

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(':');
    if (line.starts_with("model name") && colon != std::string::npos && colon + 2 <= line.size()) {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

// The cores that this process may use. In a container they may be fewer than the machine has.
int usable_cores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

double load_average() {
  double load = 0.0;
  return getloadavg(&load, 1) == 1 ? load : 0.0;
}

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

std::string host_name() {
  // Several nodes of a cluster may run on one machine, so Slurm's name of the node comes first.
  if (std::string node = variable("SLURMD_NODENAME"); !node.empty()) return node;
  char name[256] = {};
  return gethostname(name, sizeof name - 1) == 0 ? name : "unknown";
}

std::string slurm_task() {
  const std::string array = variable("SLURM_ARRAY_JOB_ID");
  return array.empty() ? variable("SLURM_JOB_ID") : array + "_" + variable("SLURM_ARRAY_TASK_ID");
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32] = {};
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

Environment environment() {
  Environment here;
  here.version = ISOBENCH_VERSION;
  here.commit = git_commit;
  here.dirty = git_dirty;
  here.compiler = std::string(ISOBENCH_COMPILER);
  here.build_type = ISOBENCH_BUILD_TYPE;
  here.libraries = LibraryVersions{{"VTK", ISOBENCH_VTK_VERSION},
                                   {"CGAL", ISOBENCH_CGAL_VERSION},
                                   {"Eigen", ISOBENCH_EIGEN_VERSION},
                                   {"TBB", ISOBENCH_TBB_VERSION},
                                   {"fmt", ISOBENCH_FMT_VERSION}};
  here.host = host_name();
  here.cpu = cpu_model();
  here.cores = usable_cores();
  here.load = load_average();
  here.exclusive = !variable("ISOBENCH_EXCLUSIVE").empty();
  here.job = slurm_task();
  return here;
}

}  // namespace isobench
