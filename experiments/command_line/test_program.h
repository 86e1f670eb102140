// Runs the program itself, for the tests of what only the whole of it shows: exit codes, signals, what is left behind.
#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "isobench/foundation/testing/test_folder.h"
#include "isobench/reports/record/record.h"

namespace isobench {

inline std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

inline std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

struct Outcome {
  int code = -1;  ///< exit status; -1 where a signal ended it
  int signal = 0;
  std::string out;
  std::string err;
  double peak_memory_mb = 0.0;  ///< largest resident memory, of it or of one that it ran
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
    rusage used{};
    wait4(pid_, &status, 0, &used);
    Outcome outcome;
    outcome.peak_memory_mb = static_cast<double>(used.ru_maxrss) * 1.024e-3;
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
inline bool eventually(const std::function<bool()>& condition,
                       std::chrono::steady_clock::duration patience = std::chrono::minutes(1)) {
  const auto start = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - start < patience) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return condition();
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

/// A line's fields; quoted ones may hold commas.
inline std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> found(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted)
      found.emplace_back();
    else
      found.back() += c;
  }
  return found;
}

/// results.csv without what a computation costs and where it was done.
inline std::vector<std::vector<std::string>> figures(const std::filesystem::path& results) {
  std::istringstream text(text_of(results / "results.csv"));
  std::vector<std::vector<std::string>> rows;
  std::vector<bool> kept;
  for (std::string line; std::getline(text, line);) {
    const std::vector<std::string> all = fields(line);
    if (rows.empty()) {
      for (const std::string& name : all) {
        kept.push_back(!name.starts_with("seconds_") && name != "peak_memory_mb" && name != "host" &&
                       name != "exclusive");
      }
    }
    rows.emplace_back();
    for (std::size_t n = 0; n < all.size(); ++n) {
      if (kept.at(n)) rows.back().push_back(all[n]);
    }
  }
  return rows;
}

inline RunRecord record_of(const std::filesystem::path& results, const std::string& start) {
  return read_record(run_folder(results, start) / "run.json");
}

}  // namespace isobench
