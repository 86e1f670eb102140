// The results folder of one experiment, safe for several processes at once.
//
// A run is written into `.tmp-<run>` under an exclusive lock on `.locks/<run>` and renamed when it is complete. The
// kernel drops the lock of a process that dies, so a temporary folder whose lock can be had is a dead one's.
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
  /// std::nullopt where another process holds it.
  static std::optional<FileLock> try_lock(const std::filesystem::path& path);
  /// What the file is to hold, for others to see who has the lock.
  void write(const std::string& text) const;

 private:
  explicit FileLock(Descriptor file) : file_(std::move(file)) {}
  Descriptor file_;
};

/// The right to do one run. Its temporary folder disappears with it unless it was committed.
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
  /// Makes the folder the run's, in the place of an earlier one. It must hold a run.json.
  void commit();

 private:
  FileLock lock_;
  std::filesystem::path temporary_;
  std::filesystem::path final_;
};

enum class RunState {
  missing,    ///< never run, or its record is damaged or of something else
  retry,      ///< failed, or out of time or memory
  done,       ///< ok or skipped
  elsewhere,  ///< not done, but another process is at it
};

/// Who is at a run, or was last.
struct Owner {
  std::string host;
  int pid = 0;
  std::string job;    ///< "123_4", of a Slurm task; "" elsewhere
  std::string since;  ///< UTC, ISO 8601
};

class Store {
 public:
  /// Makes or opens `folder` for a config, removes what dead processes left and writes config.toml, plan.json and
  /// published.toml. Throws UsageError where the folder belongs to another config, or is something else.
  Store(std::filesystem::path folder, const Config& config, const std::vector<RunRequest>& plan);

  /// A results folder that is there, as it is.
  explicit Store(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::filesystem::create_directories(folder_ / ".locks");  // a copied folder may have come without
  }

  const std::filesystem::path& folder() const { return folder_; }
  RunState state(const RunRequest& request) const;
  /// When the stored record of a run was written; std::nullopt where there is none. Differs for every record.
  std::optional<std::filesystem::file_time_type> recorded(const RunRequest& request) const;
  /// std::nullopt where another process is doing this run.
  std::optional<Claim> claim(const RunRequest& request) const;
  /// Held while a timed run goes on, so that no other process of this machine runs one of this folder beside it;
  /// std::nullopt where another process holds it.
  std::optional<FileLock> claim_quiet() const;

 private:
  std::filesystem::path folder_;
};

/// Held while the files beside the runs (plan, tables, results.csv) are read and written, so that the last process to
/// finish writes what all have done. Waits for it; throws Error after three minutes, far more than a report takes.
FileLock lock_results(const std::filesystem::path& folder);
/// write_report() under that lock.
Report write_report_locked(const std::filesystem::path& folder, ReportParts parts);

/// What is stored of a run, and whether a living process is at it. Makes and touches nothing.
struct StoredRun {
  std::optional<Status> status;  ///< std::nullopt where there is no record, or one that is damaged or of something else
  bool elsewhere = false;
};
StoredRun stored_run(const std::filesystem::path& folder, const RunRequest& request);
/// What Store::state() would say, and `elsewhere` for what another process is at, without making or touching anything.
RunState run_state(const std::filesystem::path& folder, const RunRequest& request);
/// Who claimed a run last; std::nullopt where nobody did.
std::optional<Owner> last_owner(const std::filesystem::path& folder, const std::string& run);
/// Throws UsageError where a results folder that exists does not belong to this config.
void check_folder(const std::filesystem::path& folder, const Config& config);

}  // namespace isobench
