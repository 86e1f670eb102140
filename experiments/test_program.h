// Runs the program itself, for the tests of what only the whole of it shows: exit codes, signals, what is left behind.
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "datasets/test_folder.h"
#include "reports/record.h"

namespace isobench {

inline std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

struct Outcome {
  int code = -1;  ///< exit status; -1 where a signal ended it
  int signal = 0;
  std::string out;
  std::string err;
};

/// The program running in a folder, with additions to the environment.
class Program {
 public:
  Program(const std::filesystem::path& folder, std::vector<std::string> arguments,
          const std::map<std::string, std::string>& environment = {})
      : folder_(folder) {
    arguments.insert(arguments.begin(), ISOBENCH_PROGRAM);
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    pid_ = fork();
    if (pid_ != 0) return;
    setenv("ISOBENCH_TABLES_ONLY", "1", 0);  // what a page takes is for the tests of the page
    for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
    const bool ready = chdir(folder.c_str()) == 0;
    dup2(open("stdout.txt", O_WRONLY | O_CREAT | O_TRUNC, 0644), STDOUT_FILENO);
    dup2(open("stderr.txt", O_WRONLY | O_CREAT | O_TRUNC, 0644), STDERR_FILENO);
    if (ready) execv(ISOBENCH_PROGRAM, pointers.data());
    _exit(126);
  }
  void signal(int number) const { kill(pid_, number); }
  Outcome wait() const {
    int status = 0;
    waitpid(pid_, &status, 0);
    Outcome outcome;
    if (WIFEXITED(status)) outcome.code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
    outcome.out = text_of(folder_ / "stdout.txt");
    outcome.err = text_of(folder_ / "stderr.txt");
    return outcome;
  }

 private:
  std::filesystem::path folder_;
  int pid_ = -1;
};

inline Outcome run_program(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                           const std::map<std::string, std::string>& environment = {}) {
  return Program(folder, arguments, environment).wait();
}

inline std::filesystem::path run_folder(const std::filesystem::path& results, const std::string& start) {
  for (const auto& entry : std::filesystem::directory_iterator(results)) {
    if (entry.path().filename().string().starts_with(start)) return entry.path();
  }
  return {};
}

inline std::size_t count_starting(const std::filesystem::path& folder, const std::string& start) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().filename().string().starts_with(start)) ++count;
  }
  return count;
}

/// True once the condition holds; gives up after a minute, far above what a phantom takes even under a sanitizer.
inline bool eventually(const std::function<bool()>& condition) {
  for (int tries = 0; tries < 6000; ++tries) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

/// The processes that were started with `text` among their arguments.
inline std::vector<int> processes_mentioning(const std::string& text) {
  std::vector<int> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    if (text_of(entry.path() / "cmdline").find(text) != std::string::npos) found.push_back(std::stoi(name));
  }
  return found;
}
inline bool process_mentions(const std::string& text) { return !processes_mentioning(text).empty(); }

inline RunRecord record_of(const std::filesystem::path& results, const std::string& start) {
  return read_record(run_folder(results, start) / "run.json");
}

}  // namespace isobench
