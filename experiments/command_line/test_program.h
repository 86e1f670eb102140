// For tests: runs isobench itself and looks at exit codes, signals and what is left behind.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "isobench/foundation/files/whole_files.h"
#include "isobench/foundation/processes/child_process.h"
#include "isobench/foundation/testing/eventually.h"
#include "isobench/foundation/testing/test_folder.h"
#include "isobench/reports/record/record.h"

namespace isobench {

inline std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

struct Outcome {
  int code = -1;  ///< exit status; -1 if a signal ended it
  int signal = 0;
  std::string out;
  std::string err;
  double peak_memory_mb = 0.0;  ///< see ChildExit
};

/// isobench running in a folder, with variables added to its environment. What it prints goes to stdout.txt and
/// stderr.txt there.
class Program {
 public:
  Program(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
          std::map<std::string, std::string> environment = {})
      : folder_(folder), child_(options(folder, arguments, std::move(environment))) {}

  void signal(int number) const { child_.signal(number); }
  Outcome wait() {
    const ChildExit exit = child_.wait();
    return {exit.signal != 0 ? -1 : exit.code, exit.signal, read_text_or_empty(folder_ / "stdout.txt"),
            read_text_or_empty(folder_ / "stderr.txt"), exit.peak_memory_mb};
  }

 private:
  static ChildOptions options(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                              std::map<std::string, std::string> environment) {
    // Only the tests of the page need pages; in other tests they would only take time.
    if (std::getenv("ISOBENCH_TABLES_ONLY") == nullptr) environment.try_emplace("ISOBENCH_TABLES_ONLY", "1");
    return {.words = with({ISOBENCH_PROGRAM}, arguments),
            .folder = folder,
            .out = {ChildOutput::To::new_file, folder / "stdout.txt"},
            .err = ChildOutput{ChildOutput::To::new_file, folder / "stderr.txt"},
            .environment = std::move(environment)};
  }

  std::filesystem::path folder_;
  ChildProcess child_;
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

/// The processes whose command line contains `text`.
inline std::vector<int> processes_mentioning(const std::string& text) {
  std::vector<int> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    if (read_text_or_empty(entry.path() / "cmdline").find(text) != std::string::npos) found.push_back(std::stoi(name));
  }
  return found;
}
inline bool process_mentions(const std::string& text) { return !processes_mentioning(text).empty(); }

/// The fields of a line of CSV; a quoted field may contain commas.
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

/// The rows of results.csv without the columns that tell the cost of a run and where it was done.
inline std::vector<std::vector<std::string>> figures(const std::filesystem::path& results) {
  std::istringstream text(read_text_or_empty(results / "results.csv"));
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
