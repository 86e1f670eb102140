#include "isobench/experiments/cluster/slurm.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <sstream>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

// The reading ends of a child's two streams, until both are at their end.
void read_both(std::array<int, 2> ends, std::array<std::string*, 2> texts) {
  std::array<pollfd, 2> watched = {pollfd{ends[0], POLLIN, 0}, pollfd{ends[1], POLLIN, 0}};
  int open_ends = 2;
  while (open_ends > 0) {
    if (poll(watched.data(), watched.size(), -1) < 0 && errno != EINTR) break;
    for (std::size_t n = 0; n < 2; ++n) {
      if (watched[n].fd < 0 || watched[n].revents == 0) continue;
      std::array<char, 65536> block{};
      const ssize_t got = read(watched[n].fd, block.data(), block.size());
      if (got > 0) texts[n]->append(block.data(), static_cast<std::size_t>(got));
      if (got == 0 || (got < 0 && errno != EINTR)) {
        watched[n].fd = -1;
        --open_ends;
      }
    }
  }
}

std::string trimmed(std::string text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.pop_back();
  return text;
}

}  // namespace

CommandOutput run_command(const std::vector<std::string>& words) {
  std::array<int, 2> out{};
  std::array<int, 2> err{};
  if (pipe2(out.data(), O_CLOEXEC) != 0 || pipe2(err.data(), O_CLOEXEC) != 0)
    throw Error(std::string("no pipe can be made: ") + std::strerror(errno));
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err[1], STDERR_FILENO);
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int problem = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(out[1]);
  close(err[1]);
  CommandOutput output;
  if (problem == 0) read_both({out[0], err[0]}, {&output.out, &output.err});
  close(out[0]);
  close(err[0]);
  if (problem != 0) throw Error(words.front() + " cannot be started: " + std::strerror(problem));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  output.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return output;
}

bool has_slurm() {
  try {
    return run_command({"sbatch", "--version"}).code == 0;
  } catch (const Error&) {
    return false;
  }
}

std::size_t most_tasks() {
  constexpr std::size_t usual = 1000;  // Slurm's default is 1001, which counts an index 0
  const CommandOutput config = run_command({"scontrol", "show", "config"});
  const std::size_t at = config.out.find("MaxArraySize");
  if (config.code != 0 || at == std::string::npos) return usual;
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
  if (output.code != 0 || job.empty() || job.find_first_not_of("0123456789") != std::string::npos)
    throw Error("sbatch refused: " + trimmed(output.err.empty() ? output.out : output.err));
  return job;
}

std::optional<std::map<std::string, std::string>> queued_tasks(const std::vector<std::string>& jobs) {
  std::map<std::string, std::string> tasks;
  // One by one: asked for several, squeue fails where it has forgotten one.
  for (const std::string& job : jobs) {
    CommandOutput output;
    try {
      output = run_command({"squeue", "--noheader", "--array", "--format=%i %T", "--jobs=" + job});
    } catch (const Error&) {
      return std::nullopt;
    }
    if (output.code != 0 && output.err.find("Invalid job id") == std::string::npos) return std::nullopt;
    std::istringstream lines(output.out);
    for (std::string task, state; lines >> task >> state;) tasks[task] = state;
  }
  return tasks;
}

}  // namespace isobench
