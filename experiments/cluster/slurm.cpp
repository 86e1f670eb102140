#include "isobench/experiments/cluster/slurm.h"

#include <charconv>
#include <sstream>

#include "isobench/foundation/error.h"
#include "isobench/foundation/processes/run_command.h"
#include "isobench/foundation/text.h"

namespace isobench {

bool has_slurm() {
  try {
    return run_command({"sbatch", "--version"}).exit.succeeded();
  } catch (const Error&) {
    return false;
  }
}

std::size_t most_tasks() {
  constexpr std::size_t usual = 1000;  // Slurm's default for MaxArraySize is 1001, one more than the largest index
  const CommandOutput config = run_command({"scontrol", "show", "config"});
  const std::size_t at = config.out.find("MaxArraySize");
  if (!config.exit.succeeded() || at == std::string::npos) return usual;
  const std::size_t digits = config.out.find_first_of("0123456789", at);
  std::size_t size = 0;
  if (digits == std::string::npos) return usual;
  std::from_chars(config.out.data() + digits, config.out.data() + config.out.size(), size);
  return size > 1 ? size - 1 : usual;
}

std::string submit_batch(const std::vector<std::string>& words) {
  std::vector<std::string> command = {"sbatch", "--parsable"};
  command.insert(command.end(), words.begin(), words.end());
  const CommandOutput output = run_command(command);
  // "123" or "123;cluster"
  std::string job = trimmed(output.out.substr(0, output.out.find(';')));
  if (!output.exit.succeeded() || job.empty() || job.find_first_not_of("0123456789") != std::string::npos)
    throw Error("sbatch refused: " + trimmed(output.err.empty() ? output.out : output.err));
  return job;
}

std::optional<std::map<std::string, std::string>> queued_tasks(const std::vector<std::string>& jobs) {
  std::map<std::string, std::string> tasks;
  // Ask for one job at a time: for several jobs squeue fails if it no longer knows one of them.
  for (const std::string& job : jobs) {
    CommandOutput output;
    try {
      output = run_command({"squeue", "--noheader", "--array", "--format=%i %T", "--jobs=" + job});
    } catch (const Error&) {
      return std::nullopt;
    }
    if (!output.exit.succeeded() && output.err.find("Invalid job id") == std::string::npos) return std::nullopt;
    std::istringstream lines(output.out);
    for (std::string task, state; lines >> task >> state;) tasks[task] = state;
  }
  return tasks;
}

}  // namespace isobench
