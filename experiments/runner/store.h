// The results folder of one experiment. Several processes may use it at once.
//
// A run is written to `.tmp-<run>` under an exclusive lock on `.locks/<run>`, and its folder is renamed when it is
// complete. The kernel releases the lock of a process that dies, so a temporary folder whose lock is free belongs to a
// dead process.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isobench/experiments/plan/config.h"
#include "isobench/foundation/processes/descriptor.h"
#include "isobench/reports/record/record.h"
#include "isobench/reports/report.h"

namespace isobench {

/// An exclusive lock on a file, held until destruction.
class FileLock {
 public:
  /// std::nullopt if another process holds it.
  static std::optional<FileLock> try_lock(const std::filesystem::path& path);
  /// Replaces the content of the file, which tells other processes who holds the lock.
  void write(const std::string& text) const;

 private:
  explicit FileLock(Descriptor file) : file_(std::move(file)) {}
  Descriptor file_;
};

/// The right to do one run. Its temporary folder is removed when the scope ends, unless it was committed.
class Claim {
 public:
  Claim(FileLock lock, std::filesystem::path temporary, std::filesystem::path final);
  ~Claim();
  Claim(Claim&& other) noexcept;
  Claim& operator=(Claim&&) = delete;
  Claim(const Claim&) = delete;
  Claim& operator=(const Claim&) = delete;

  /// Where to write.
  const std::filesystem::path& folder() const { return temporary_; }
  /// Turns the temporary folder into the folder of the run and replaces an earlier one. It must contain run.json.
  void commit();

 private:
  FileLock lock_;
  std::filesystem::path temporary_;
  std::filesystem::path final_;
};

enum class RunState {
  missing,    ///< never run, or the record is damaged or belongs to another request
  retry,      ///< failed, or exceeded a limit of time or memory
  done,       ///< ok or skipped
  elsewhere,  ///< not done, but another process is working on it
};

/// The process that works on a run, or did so last.
struct Owner {
  std::string host;
  int pid = 0;
  std::string job;    ///< the Slurm task, such as "123_4"; "" if there is none
  std::string since;  ///< UTC, ISO 8601
};

class Store {
 public:
  /// Makes or opens `folder` for a config. Removes what killed processes left, and writes config.toml, plan.json and
  /// published.toml. Throws UsageError if the folder belongs to another config or is not a results folder.
  Store(std::filesystem::path folder, const Config& config, const std::vector<RunRequest>& plan);

  /// Opens a results folder that exists.
  explicit Store(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::filesystem::create_directories(folder_ / ".locks");  // a copied folder may lack it
  }

  const std::filesystem::path& folder() const { return folder_; }
  RunState state(const RunRequest& request) const;
  /// When the stored record of a run was written; std::nullopt if there is none. A new record has a new time.
  std::optional<std::filesystem::file_time_type> recorded(const RunRequest& request) const;
  /// std::nullopt if another process works on this run.
  std::optional<Claim> claim(const RunRequest& request) const;
  /// The lock of a timed run: no two processes on this machine do timed runs of this folder at once. std::nullopt if
  /// another process holds it.
  std::optional<FileLock> claim_quiet() const;

 private:
  std::filesystem::path folder_;
};

/// The lock for the files beside the runs (plan, tables, results.csv). A process holds it while it reads the runs and
/// writes the tables, so that the tables of the last process to finish have the runs of all processes. Waits for the
/// lock; throws Error after three minutes, which is far more than a report takes.
FileLock lock_results(const std::filesystem::path& folder);
/// write_report() under that lock.
Report write_report_locked(const std::filesystem::path& folder, ReportParts parts);

/// The stored state of a run, and whether a process works on it. Changes nothing on disk.
struct StoredRun {
  std::optional<Status> status;  ///< std::nullopt as for RunState::missing
  bool elsewhere = false;
};
StoredRun stored_run(const std::filesystem::path& folder, const RunRequest& request);
/// As Store::state(), but also tells `elsewhere`. Changes nothing on disk.
RunState run_state(const std::filesystem::path& folder, const RunRequest& request);
/// The process that claimed a run last; std::nullopt if none did.
std::optional<Owner> last_owner(const std::filesystem::path& folder, const std::string& run);
/// Throws UsageError if the folder exists and does not belong to this config.
void check_folder(const std::filesystem::path& folder, const Config& config);

}  // namespace isobench
