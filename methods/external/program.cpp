#include "isobench/methods/external/program.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace isobench::external {

namespace {

// Kills and reaps what a program left running. It asks the kernel to make orphans children of this process.
// Children that this process had before are spared.
class OrphanReaper {
 public:
  OrphanReaper() : before_(descendants(getpid())) { prctl(PR_SET_CHILD_SUBREAPER, 1); }
  ~OrphanReaper() {
    kill_descendants(getpid(), before_);
    if (!before_.empty()) return;  // reaping any child could take an exit status that somebody waits for
    while (waitpid(-1, nullptr, WNOHANG) > 0) {
    }
  }
  OrphanReaper(const OrphanReaper&) = delete;
  OrphanReaper& operator=(const OrphanReaper&) = delete;

 private:
  std::vector<int> before_;
};

ChildOptions options_for(const ProgramCall& call) {
  ChildOptions options{.words = call.words,
                       .folder = call.folder,
                       .out = {ChildOutput::To::end_of_file, call.log},
                       .dies_with_parent = true};
  if (call.threads > 0) options.environment["OMP_NUM_THREADS"] = std::to_string(call.threads);
  return options;
}

}  // namespace

ProgramEnd run_program(const ProgramCall& call, Monitor& monitor) {
  const OrphanReaper reaper;
  ChildProcess child(options_for(call));
  ProgramEnd end;
  std::optional<ChildExit> exit = child.poll();
  while (!exit) {
    monitor.check();
    end.peak_memory_mb = child.peak_memory_bytes() / 1e6;
    exit = child.wait_for(std::chrono::milliseconds(10));
  }
  end.exit = *exit;
  end.seconds = child.seconds();
  return end;
}

}  // namespace isobench::external
