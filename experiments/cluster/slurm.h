// The Slurm of this machine, by its own commands (22.05 and later): nothing here schedules anything itself.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace isobench {

/// What a program printed and how it ended. Throws Error where it cannot be started.
struct CommandOutput {
  int code = 0;  ///< exit status; 128 + the signal where one ended it
  std::string out;
  std::string err;
};
CommandOutput run_command(const std::vector<std::string>& words);

/// Whether `sbatch` can be called here.
bool has_slurm();

/// Tasks that one job array may have (MaxArraySize of the cluster; 1000 where it does not say).
std::size_t most_tasks();

/// sbatch --parsable, with these words after it; the job's number. Throws Error with what sbatch said.
std::string submit_batch(const std::vector<std::string>& words);

/// Tasks of these jobs that are waiting or running, "123_4" → "PENDING"; std::nullopt where squeue cannot be asked.
/// A job that squeue no longer knows has none.
std::optional<std::map<std::string, std::string>> queued_tasks(const std::vector<std::string>& jobs);

}  // namespace isobench
