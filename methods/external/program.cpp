#include "isobench/methods/external/program.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <fstream>
#include <optional>
#include <sstream>

#include "isobench/foundation/error.h"
#include "isobench/foundation/processes.h"

namespace isobench::external {

namespace {

namespace fs = std::filesystem;

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return number_; }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

std::vector<std::string> environment(int threads) {
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string text = *variable;
    if (threads > 0 && text.starts_with("OMP_NUM_THREADS=")) continue;
    variables.push_back(text);
  }
  if (threads > 0) variables.push_back("OMP_NUM_THREADS=" + std::to_string(threads));
  return variables;
}

// All that is needed between fork and exec, made before: only calls that are safe there may follow.
struct Start {
  std::string program;
  std::vector<char*> arguments;
  std::vector<char*> variables;
  std::string folder;
  int log;
  int failure;  // where to say why it came to nothing
  int parent;
};

[[noreturn]] void become(const Start& start) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != start.parent) _exit(127);  // the parent died before the line above
  std::signal(SIGPIPE, SIG_DFL);              // which we may ignore
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(start.log, STDOUT_FILENO);
  dup2(start.log, STDERR_FILENO);
  if (chdir(start.folder.c_str()) == 0) {
    execve(start.program.c_str(), start.arguments.data(), start.variables.data());
  }
  const int error = errno;
  [[maybe_unused]] const ssize_t written = write(start.failure, &error, sizeof error);
  _exit(127);
}

// Kills and reaps what is left of a program, however it came to its end. Orphans of it come to us, as this process has
// asked for them; children that were there before are spared.
class Remains {
 public:
  Remains() : before_(descendants(getpid())) { prctl(PR_SET_CHILD_SUBREAPER, 1); }
  ~Remains() {
    kill_descendants(getpid(), before_);
    if (pid_ > 0) waitpid(pid_, nullptr, 0);  // nothing happens where that was done
    if (!before_.empty()) return;             // whose end others may be waiting for
    while (waitpid(-1, nullptr, WNOHANG) > 0) {
    }
  }
  Remains(const Remains&) = delete;
  Remains& operator=(const Remains&) = delete;
  void of(int pid) { pid_ = pid; }

 private:
  std::vector<int> before_;
  int pid_ = 0;
};

// Why exec failed; std::nullopt where it did not. Waits for it.
std::optional<int> failure_of(int pipe) {
  int error = 0;
  ssize_t count = 0;
  do count = read(pipe, &error, sizeof error);
  while (count < 0 && errno == EINTR);
  return count == sizeof error ? std::optional(error) : std::nullopt;
}

ProgramEnd wait_for(int pid, const Monitor& monitor) {
  // Wakes up at once when the program ends; where the kernel has no such thing, a hundredth of a second later.
  const Descriptor ending(static_cast<int>(syscall(SYS_pidfd_open, pid, 0)));
  MemoryWatch memory(pid);
  ProgramEnd end;
  int status = 0;
  while (waitpid(pid, &status, WNOHANG) != pid) {
    monitor.check();
    end.peak_memory_mb = memory.look() / 1e6;
    pollfd watched{ending.get(), POLLIN, 0};
    poll(&watched, 1, 10);
  }
  if (WIFSIGNALED(status))
    end.signal = WTERMSIG(status);
  else
    end.code = WEXITSTATUS(status);
  return end;
}

}  // namespace

fs::path find_program(const std::string& name) {
  const auto runs = [](const fs::path& path) { return fs::is_regular_file(path) && access(path.c_str(), X_OK) == 0; };
  if (name.find('/') != std::string::npos) {
    if (runs(name)) return fs::absolute(name);
    throw Error("there is no program '" + name + "', or it is not executable");
  }
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "/usr/local/bin:/usr/bin:/bin" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (!folder.empty() && runs(fs::path(folder) / name)) return fs::absolute(fs::path(folder) / name);
  }
  throw Error("there is no program '" + name + "' in PATH; install it, or give its path");
}

ProgramEnd run_program(const ProgramCall& call, Monitor& monitor) {
  const fs::path program = find_program(call.words.at(0));
  const Descriptor log(open(call.log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644));
  if (log.get() < 0) throw Error(call.log.string() + ": cannot be written: " + std::strerror(errno));
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw Error(std::string("no pipe for a program: ") + std::strerror(errno));
  const Descriptor failure(ends[0]);
  Descriptor told(ends[1]);
  std::vector<std::string> words = call.words;
  std::vector<std::string> variables = environment(call.threads);
  const Start start{program.string(), pointers(words), pointers(variables), call.folder.string(), log.get(),
                    told.get(),       getpid()};
  Remains remains;
  const auto begun = std::chrono::steady_clock::now();
  const int pid = fork();
  if (pid == 0) become(start);
  if (pid < 0) throw Error(std::string("no process for a program: ") + std::strerror(errno));
  remains.of(pid);
  told.close();
  if (const std::optional<int> error = failure_of(failure.get())) {
    throw Error(program.string() + " cannot be started: " + std::strerror(*error));
  }
  ProgramEnd end = wait_for(pid, monitor);
  end.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  return end;
}

std::string last_lines(const fs::path& file, std::uintmax_t begin, std::size_t count) {
  constexpr std::streamoff most = 4096;  // however much a program has written
  std::ifstream log(file, std::ios::binary | std::ios::ate);
  const std::streamoff length = log.tellg();
  log.seekg(std::max({length - most, static_cast<std::streamoff>(begin), std::streamoff{0}}));
  std::deque<std::string> lines;
  for (std::string line; std::getline(log, line);) {
    if (line.find_first_not_of(" \t\r.") == std::string::npos) continue;
    lines.push_back(line);
    if (lines.size() > count) lines.pop_front();
  }
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : " | ") + line;
  return text;
}

}  // namespace isobench::external
