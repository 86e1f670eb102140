// For tests: a Slurm cluster of two virtual nodes on this machine, made from Debian's packages.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <random>
#include <string>

#include "isobench/experiments/command_line/test_program.h"
#include "isobench/foundation/processes/run_command.h"
#include "isobench/foundation/testing/test_folder.h"
#include "isobench/foundation/testing/test_variable.h"

namespace isobench {

/// Why there can be no cluster here; "" if there can be one.
inline std::string no_cluster() {
  if (geteuid() != 0) return "slurmd must be started by root, and this is not root";
  for (const char* program : {"munged", "slurmctld", "slurmd", "sbatch", "squeue"}) {
    if (!has_program(program)) return fmt::format("{} is missing: apt-get install slurm-wlm munge", program);
  }
  return "";
}

class Cluster {
 public:
  Cluster() {
    const std::string root = folder_.path().string();
    start_munge();
    // Ports that no other cluster uses while tests run side by side. They lie below those of outgoing connections.
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
    start({"slurmctld"});
    start_node("n1");
    start_node("n2");
    ready_ = eventually([] { return run_command({"sinfo", "--noheader", "--format=%T"}).out == "idle\n"; });
  }
  ~Cluster() {
    run_command({"scancel", "--user=root"});
    for (const char* name : {"slurmd-n1.pid", "slurmd-n2.pid", "slurmctld.pid", "munge/pid"}) stop(name);
  }
  Cluster(const Cluster&) = delete;
  Cluster& operator=(const Cluster&) = delete;

  bool ready() const { return ready_; }
  std::string configuration() const { return (folder_.path() / "slurm.conf").string(); }
  void start_node(const std::string& name) const { start({"slurmd", "-N", name}); }
  /// What the loss of power does to a node: kills its daemon and everything that the daemon started.
  void kill_node(const std::string& name) const {
    stop("slurmd-" + name + ".pid");
    for (const std::string& who : {std::string("slurmstepd: ["), folder_of_runs_}) {
      for (const int pid : processes_mentioning(who)) {
        const std::string variables = read_text_or_empty(fmt::format("/proc/{}/environ", pid));
        const auto has = [&variables](const std::string& part) { return variables.find(part) != std::string::npos; };
        // The cluster of another test has nodes of the same names.
        if (has("SLURMD_NODENAME=" + name) && has("SLURM_CONF=" + configuration())) kill(pid, SIGKILL);
      }
    }
  }
  void runs_in(const std::string& folder) { folder_of_runs_ = folder; }
  /// Waits until no job is queued or running.
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
  void start_munge() const {
    const std::filesystem::path munge = folder_.path() / "munge";
    // munged refuses folders that other users can write to, and a key that they can read.
    const auto for_all_to_read = static_cast<std::filesystem::perms>(0755);
    for (const auto& folder : {folder_.path(), munge, folder_.path() / "state"}) {
      std::filesystem::create_directory(folder);
      std::filesystem::permissions(folder, for_all_to_read);
    }
    std::random_device random;
    std::string key(1024, '\0');
    for (char& byte : key) byte = static_cast<char>(random());
    std::filesystem::permissions(folder_.write("munge/key", key), static_cast<std::filesystem::perms>(0600));
    const auto option = [&munge](const std::string& name, const std::string& file) {
      return "--" + name + "=" + (munge / file).string();
    };
    start({"munged", "--force", option("key-file", "key"), option("socket", "socket"), option("pid-file", "pid"),
           option("log-file", "log"), option("seed-file", "seed")});
  }
  /// Starts a daemon, which goes to the background by itself.
  static void start(const std::vector<std::string>& words) {
    const ChildExit exit = ChildProcess({.words = words}).wait();
    if (!exit.succeeded()) ADD_FAILURE() << words.front() << " " << to_string(exit);
  }
  void stop(const std::string& pid_file) const {
    std::ifstream file(folder_.path() / pid_file);
    int pid = 0;
    if (!(file >> pid)) return;
    kill(pid, SIGKILL);
    eventually([pid] { return kill(pid, 0) != 0; });
  }

  TestFolder folder_;
  TestVariable variable_{"SLURM_CONF", configuration()};
  std::string folder_of_runs_ = "\x01 none";
  bool ready_ = false;
};

}  // namespace isobench
