// Talks to Slurm (22.05 or later) on this machine through its commands. Slurm alone does the scheduling.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace isobench {

/// Whether sbatch works here.
bool has_slurm();

/// The most tasks that a job array may have: MaxArraySize of the cluster, 1000 if it does not say.
std::size_t most_tasks();

/// Calls sbatch with these arguments and returns the number of the job. Throws Error with sbatch's message if it
/// refuses.
std::string submit_batch(const std::vector<std::string>& words);

/// The tasks of these jobs that wait or run, with their states ("123_4" → "PENDING"); a job that squeue no longer knows
/// has none. std::nullopt if squeue fails.
std::optional<std::map<std::string, std::string>> queued_tasks(const std::vector<std::string>& jobs);

}  // namespace isobench
