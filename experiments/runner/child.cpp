#include "isobench/experiments/runner/child.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "isobench/foundation/error.h"
#include "isobench/foundation/processes.h"

namespace isobench {

namespace {

// Between fork and exec: only calls that are safe there.
[[noreturn]] void become(char* const* arguments, int log, int progress, int parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);  // the parent died before the line above
  const int null = open("/dev/null", O_RDONLY);
  dup2(null, STDIN_FILENO);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  fcntl(progress, F_SETFD, 0);
  fcntl(progress, F_SETFL, O_NONBLOCK);  // progress that nobody reads must not stop the work
  execv(arguments[0], arguments);
  _exit(127);
}

}  // namespace

Child::Child(std::vector<std::string> arguments, const std::filesystem::path& log) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw Error(std::string("no pipe for a child process: ") + std::strerror(errno));
  const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) {
    close(ends[0]);
    close(ends[1]);
    throw Error(log.string() + ": cannot be written: " + std::strerror(errno));
  }
  arguments.emplace_back("--progress-fd");
  arguments.push_back(std::to_string(ends[1]));
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  const int parent = getpid();
  pid_ = fork();
  if (pid_ == 0) become(pointers.data(), file, ends[1], parent);
  const int error = errno;
  close(file);
  close(ends[1]);
  pipe_ = ends[0];
  fcntl(pipe_, F_SETFL, O_NONBLOCK);
  if (pid_ < 0) {
    close(pipe_);
    throw Error(std::string("no child process: ") + std::strerror(error));
  }
  setpgid(pid_, pid_);  // in both, so that whoever comes first does it
  memory_.emplace(pid_);
}

Child::Child(Child&& other) noexcept
    : pid_(other.pid_),
      pipe_(other.pipe_),
      buffer_(std::move(other.buffer_)),
      progress_(std::move(other.progress_)),
      memory_(std::move(other.memory_)),
      start_(other.start_) {
  other.pid_ = -1;
  other.pipe_ = -1;
}

Child::~Child() {
  kill();
  if (pipe_ >= 0) close(pipe_);
}

std::optional<ChildExit> Child::poll() {
  if (pid_ < 0) return std::nullopt;
  int status = 0;
  if (waitpid(pid_, &status, WNOHANG) != pid_) return std::nullopt;
  // Whatever it started itself goes with it.
  ::kill(-pid_, SIGKILL);
  pid_ = -1;
  ChildExit result;
  if (WIFSIGNALED(status))
    result.signal = WTERMSIG(status);
  else
    result.code = WEXITSTATUS(status);
  return result;
}

void Child::kill() {
  if (pid_ < 0) return;
  // First those that it started, of which some may have left its group; stopped, it starts no more.
  ::kill(pid_, SIGSTOP);
  kill_descendants(pid_);
  ::kill(-pid_, SIGKILL);
  ::kill(pid_, SIGKILL);
  while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
}

double Child::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

double Child::peak_memory_gb() { return pid_ < 0 ? 0.0 : memory_->look() / 1e9; }

const ChildProgress& Child::progress() {
  char bytes[4096];
  for (ssize_t count = 0; (count = read(pipe_, bytes, sizeof bytes)) > 0;) {
    buffer_.append(bytes, static_cast<std::size_t>(count));
  }
  // Only the last whole line counts: it is where the child is now.
  const std::size_t end = buffer_.rfind('\n');
  if (end == std::string::npos) return progress_;
  const std::size_t before = end == 0 ? std::string::npos : buffer_.rfind('\n', end - 1);
  const std::size_t start = before == std::string::npos ? 0 : before + 1;
  const std::string line = buffer_.substr(start, end - start);
  buffer_.erase(0, end + 1);
  const std::size_t space = line.find(' ');
  if (space != std::string::npos) progress_ = {line.substr(space + 1), std::strtod(line.c_str(), nullptr)};
  return progress_;
}

}  // namespace isobench
