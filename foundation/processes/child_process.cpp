#include "isobench/foundation/processes/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

// Descriptors for a child get numbers from here on, so that none has a number that another one gets in the child.
constexpr int first_spare = 10;

Descriptor raised(Descriptor low) {
  Descriptor high(fcntl(low.get(), F_DUPFD_CLOEXEC, first_spare));
  if (!high.is_open()) throw Error(std::string("a child process needs more open files: ") + std::strerror(errno));
  return high;
}

struct Pipe {
  Descriptor reading;
  Descriptor writing;
};

Pipe open_pipe(int flags = 0) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC | flags) != 0) throw Error(std::string("no pipe can be made: ") + std::strerror(errno));
  Pipe pipe{Descriptor(ends[0]), Descriptor(ends[1])};
  pipe.writing = raised(std::move(pipe.writing));
  return pipe;
}

Descriptor open_file(const fs::path& path, int flags) {
  Descriptor file(open(path.c_str(), flags | O_CLOEXEC, 0644));
  if (!file.is_open()) throw Error(fmt::format("{}: cannot be opened: {}", path.string(), std::strerror(errno)));
  return raised(std::move(file));
}

// The child's end of an output stream, none for a stream that is inherited; `incoming` becomes this process's end.
Descriptor open_output(const ChildOutput& output, Descriptor& incoming) {
  constexpr int flags = O_WRONLY | O_CREAT;
  switch (output.to) {
    case ChildOutput::To::new_file:
      return open_file(output.file, flags | O_TRUNC);
    case ChildOutput::To::end_of_file:
      return open_file(output.file, flags | O_APPEND);
    case ChildOutput::To::text: {
      Pipe pipe = open_pipe();
      fcntl(pipe.reading.get(), F_SETFL, O_NONBLOCK);
      incoming = std::move(pipe.reading);
      return std::move(pipe.writing);
    }
    case ChildOutput::To::parents_stream:
      break;
  }
  return {};
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

std::vector<std::string> variables_with(const std::map<std::string, std::string>& changes) {
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string text = *variable;
    if (!changes.contains(text.substr(0, text.find('=')))) variables.push_back(text);
  }
  for (const auto& [name, value] : changes) variables.push_back(fmt::format("{}={}", name, value));
  return variables;
}

// Everything that is needed between fork and exec. It is prepared before, because only async-signal-safe functions may
// be called there: another thread may have held the lock of malloc when this one forked.
struct Start {
  const char* program;
  char* const* words;
  char* const* variables;
  const char* folder;  // "": stay
  int in;
  int out;  // -1: inherited
  int err;
  int pipe;     // -1: none
  int failure;  // gets errno if exec fails; exec closes it
  int parent;
  bool own_group;
  bool dies_with_parent;
};

[[noreturn]] void become(const Start& start) {
  if (start.own_group) setpgid(0, 0);
  if (start.dies_with_parent) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != start.parent) _exit(127);  // the parent died before prctl()
  }
  std::signal(SIGPIPE, SIG_DFL);  // an ignored signal stays ignored through exec
  const bool ready = dup2(start.in, STDIN_FILENO) >= 0 && (start.out < 0 || dup2(start.out, STDOUT_FILENO) >= 0) &&
                     (start.err < 0 || dup2(start.err, STDERR_FILENO) >= 0) &&
                     (start.pipe < 0 || dup2(start.pipe, ChildProcess::pipe_number) >= 0) &&
                     (start.folder[0] == '\0' || chdir(start.folder) == 0);
  if (ready) execve(start.program, start.words, start.variables);
  const int error = errno;
  [[maybe_unused]] const ssize_t written = write(start.failure, &error, sizeof error);
  _exit(127);
}

// errno of an exec that failed; std::nullopt if it succeeded. Waits for either.
std::optional<int> failure_of(const Descriptor& reading) {
  int error = 0;
  ssize_t count = 0;
  do count = read(reading.get(), &error, sizeof error);
  while (count < 0 && errno == EINTR);
  return count == sizeof error ? std::optional(error) : std::nullopt;
}

// Takes what is there to read, and closes the end if nothing can come any more.
void read_available(Descriptor& end, std::string& text) {
  std::array<char, 65536> block;
  while (end.is_open()) {
    const ssize_t count = read(end.get(), block.data(), block.size());
    if (count > 0)
      text.append(block.data(), static_cast<std::size_t>(count));
    else if (count == 0 || (errno != EAGAIN && errno != EINTR))
      end.close();
    else if (errno == EAGAIN)
      return;
  }
}

}  // namespace

fs::path find_program(const std::string& name) {
  const auto runs = [](const fs::path& path) {
    std::error_code none;
    return fs::is_regular_file(path, none) && access(path.c_str(), X_OK) == 0;
  };
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

bool has_program(const std::string& name) {
  try {
    find_program(name);
    return true;
  } catch (const Error&) {
    return false;
  }
}

std::string to_string(const ChildExit& exit) {
  return exit.signal != 0 ? "ended by " + signal_name(exit.signal) : fmt::format("ended with exit code {}", exit.code);
}

ChildProcess::ChildProcess(const ChildOptions& options) : own_group_(options.own_group) {
  const std::string program = find_program(options.words.at(0)).string();
  std::vector<std::string> words = options.words;
  std::vector<std::string> variables = variables_with(options.environment);
  const std::vector<char*> word_pointers = pointers(words);
  const std::vector<char*> variable_pointers = pointers(variables);
  const Descriptor in = open_file("/dev/null", O_RDONLY);
  const Descriptor out = open_output(options.out, incoming_[0].end);
  const Descriptor err = options.err ? open_output(*options.err, incoming_[1].end) : Descriptor();
  Pipe pipe;
  if (options.pipe) {
    pipe = open_pipe(O_NONBLOCK);
    incoming_[2].end = std::move(pipe.reading);
  }
  Pipe failure = open_pipe();
  const int err_number = options.err ? err.get() : out.is_open() ? out.get() : STDOUT_FILENO;
  const Start start{program.c_str(),
                    word_pointers.data(),
                    variable_pointers.data(),
                    options.folder.c_str(),
                    in.get(),
                    out.get(),
                    err_number,
                    pipe.writing.get(),
                    failure.writing.get(),
                    getpid(),
                    own_group_,
                    options.dies_with_parent};
  start_ = std::chrono::steady_clock::now();
  pid_ = fork();
  if (pid_ == 0) become(start);
  if (pid_ < 0) throw Error(program + " cannot be started: " + std::strerror(errno));
  if (own_group_) setpgid(pid_, pid_);  // in both processes, so that the group exists whichever runs first
  failure.writing.close();
  if (const std::optional<int> error = failure_of(failure.reading)) {
    kill();
    throw Error(program + " cannot be started: " + std::strerror(*error));
  }
  ending_ = Descriptor(static_cast<int>(syscall(SYS_pidfd_open, pid_, 0)));
  memory_.emplace(pid_);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      own_group_(other.own_group_),
      ending_(std::move(other.ending_)),
      incoming_(std::move(other.incoming_)),
      exit_(other.exit_),
      memory_(std::move(other.memory_)),
      peak_memory_bytes_(other.peak_memory_bytes_),
      start_(other.start_) {}

ChildProcess::~ChildProcess() { kill(); }

void ChildProcess::collect(int flags) {
  if (exit_ || pid_ < 0) return;
  int status = 0;
  rusage used{};
  pid_t found = 0;
  do found = wait4(pid_, &status, flags, &used);
  while (found < 0 && errno == EINTR);
  if (found == 0) return;  // it still runs
  if (own_group_) ::kill(-pid_, SIGKILL);
  pid_ = -1;
  exit_ = ChildExit{-1, 0, 0.0};
  if (found > 0) {
    exit_->code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    exit_->signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    exit_->peak_memory_mb = static_cast<double>(used.ru_maxrss) * 1024.0 / 1e6;
  }
}

void ChildProcess::read_texts() {
  for (const std::size_t stream : {0U, 1U}) read_available(incoming_[stream].end, incoming_[stream].text);
}

std::optional<ChildExit> ChildProcess::poll() {
  read_texts();
  collect(WNOHANG);
  return exit_;
}

std::optional<ChildExit> ChildProcess::wait_for(std::chrono::milliseconds time) {
  if (!exit_ && pid_ >= 0) {
    // Without pidfd_open (before Linux 5.3) this waits for the whole time.
    pollfd watched{ending_.get(), POLLIN, 0};
    ::poll(&watched, 1, static_cast<int>(time.count()));
  }
  return poll();
}

ChildExit ChildProcess::wait() {
  while (incoming_[0].end.is_open() || incoming_[1].end.is_open()) {
    std::array<pollfd, 2> watched = {pollfd{incoming_[0].end.get(), POLLIN, 0},
                                     pollfd{incoming_[1].end.get(), POLLIN, 0}};
    ::poll(watched.data(), watched.size(), -1);
    read_texts();
  }
  collect(0);
  return exit_.value_or(ChildExit{-1, 0, 0.0});
}

void ChildProcess::signal(int number) const {
  if (pid_ >= 0) ::kill(pid_, number);
}

void ChildProcess::kill() {
  if (pid_ < 0) return;
  // First its descendants, because some may have left its group. While it is stopped, it starts no more.
  ::kill(pid_, SIGSTOP);
  kill_descendants(pid_);
  if (own_group_) ::kill(-pid_, SIGKILL);
  ::kill(pid_, SIGKILL);
  for (Incoming& incoming : incoming_) incoming.end.close();
  wait();
}

double ChildProcess::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

double ChildProcess::peak_memory_bytes() {
  if (pid_ >= 0) peak_memory_bytes_ = memory_->look();
  return peak_memory_bytes_;
}

std::string ChildProcess::take_from_pipe() {
  read_available(incoming_[2].end, incoming_[2].text);
  return std::exchange(incoming_[2].text, {});
}

}  // namespace isobench
