// A Slurm cluster of two virtual nodes on this machine, from Debian's packages, for as long as a test needs it.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <string>

#include "isobench/experiments/cluster/slurm.h"
#include "isobench/experiments/command_line/test_program.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {

/// Why there can be no cluster here; "" where there can.
inline std::string no_cluster() {
  if (geteuid() != 0) return "slurmd runs as root alone, and this is not root";
  for (const char* program : {"munged", "slurmctld", "slurmd", "sbatch", "squeue"}) {
    if (std::system(fmt::format("command -v {} >/dev/null 2>&1", program).c_str()) != 0)
      return fmt::format("{} is missing: apt-get install slurm-wlm munge", program);
  }
  return "";
}

class Cluster {
 public:
  Cluster() {
    const std::string root = folder_.path().string();
    // munged insists on folders that no other user can write.
    run(
        fmt::format("chmod 755 {0} && mkdir -m 755 {0}/munge {0}/state && head -c 1024 /dev/urandom >{0}/munge/key && "
                    "chmod 600 {0}/munge/key",
                    root));
    run(
        fmt::format("munged --force --key-file={0}/munge/key --socket={0}/munge/socket --pid-file={0}/munge/pid "
                    "--log-file={0}/munge/log --seed-file={0}/munge/seed",
                    root));
    // Ports that another cluster of a test running beside this one does not have, below those of outgoing connections.
    const int port = 10000 + 4 * (getpid() % 5000);
    folder_.write("slurm.conf", fmt::format(R"(ClusterName=test
SlurmctldHost={1}
SlurmctldPort={2}
SlurmUser=root
AuthInfo=socket={0}/munge/socket
StateSaveLocation={0}/state
SlurmdSpoolDir={0}/spool-%n
SlurmctldPidFile={0}/slurmctld.pid
SlurmdPidFile={0}/slurmd-%n.pid
SlurmctldLogFile={0}/slurmctld.log
SlurmdLogFile={0}/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
SchedulerParameters=batch_sched_delay=1,sched_interval=1
ReturnToService=2
MpiDefault=none
AccountingStorageType=accounting_storage/none
KillWait=2
SlurmdTimeout=30
SlurmdParameters=config_overrides
MaxArraySize=50
NodeName=n1 NodeHostname={1} Port={3} CPUs=1 RealMemory=6000
NodeName=n2 NodeHostname={1} Port={4} CPUs=1 RealMemory=6000
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
)",
                                            root, host(), port, port + 1, port + 2));
    setenv("SLURM_CONF", configuration().c_str(), 1);
    run("slurmctld");
    start_node("n1");
    start_node("n2");
    ready_ = eventually([] { return run_command({"sinfo", "--noheader", "--format=%T"}).out == "idle\n"; });
  }
  ~Cluster() {
    run_command({"scancel", "--user=root"});
    for (const char* name : {"slurmd-n1.pid", "slurmd-n2.pid", "slurmctld.pid", "munge/pid"}) stop(name);
    unsetenv("SLURM_CONF");
  }
  Cluster(const Cluster&) = delete;
  Cluster& operator=(const Cluster&) = delete;

  bool ready() const { return ready_; }
  std::string configuration() const { return (folder_.path() / "slurm.conf").string(); }
  void start_node(const std::string& name) const { run("slurmd -N " + name); }
  /// As a node that loses its power: the daemon and all that it had started.
  void kill_node(const std::string& name) const {
    stop("slurmd-" + name + ".pid");
    for (const std::string& who : {std::string("slurmstepd: ["), folder_of_runs_}) {
      for (const int pid : processes_mentioning(who)) {
        const std::string variables = read_text_or_empty(fmt::format("/proc/{}/environ", pid));
        const auto has = [&variables](const std::string& part) { return variables.find(part) != std::string::npos; };
        // Another test's cluster has nodes of the same names.
        if (has("SLURMD_NODENAME=" + name) && has("SLURM_CONF=" + configuration())) kill(pid, SIGKILL);
      }
    }
  }
  void runs_in(const std::string& folder) { folder_of_runs_ = folder; }
  /// Waits until nothing is queued or running any more.
  static bool drained() {
    return eventually([] { return run_command({"squeue", "--noheader"}).out.empty(); }, std::chrono::minutes(5));
  }

 private:
  static std::string host() {
    char name[256] = {};
    gethostname(name, sizeof name - 1);
    const std::string full = name;
    return full.substr(0, full.find('.'));
  }
  static void run(const std::string& command) {
    if (std::system(command.c_str()) != 0) ADD_FAILURE() << "cannot: " << command;
  }
  void stop(const std::string& pid_file) const {
    std::ifstream file(folder_.path() / pid_file);
    int pid = 0;
    if (!(file >> pid)) return;
    kill(pid, SIGKILL);
    eventually([pid] { return kill(pid, 0) != 0; });
  }

  TestFolder folder_;
  std::string folder_of_runs_ = "\x01 none";
  bool ready_ = false;
};

}  // namespace isobench
