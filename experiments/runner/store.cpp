#include "isobench/experiments/runner/store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <thread>

#include "isobench/experiments/plan/plan.h"
#include "isobench/reports/record/environment.h"
#include "isobench/reports/report.h"

namespace isobench {

namespace fs = std::filesystem;

namespace {

const std::string temporary_prefix = ".tmp-";
const std::string replaced_prefix = ".old-";

fs::path lock_path(const fs::path& folder, const std::string& run) { return folder / ".locks" / run; }

// commit() moves an old run aside before it renames the new one. If it was killed in between, restore the old run.
void settle_replaced(const fs::path& folder, const std::string& run) {
  const fs::path old = folder / (replaced_prefix + run);
  if (!fs::exists(old)) return;
  if (fs::exists(folder / run))
    fs::remove_all(old);
  else
    fs::rename(old, folder / run);
}

Owner this_process() { return {host_name(), getpid(), slurm_task(), utc_now()}; }

std::string owner_text(const Owner& owner) {
  return fmt::format("{} {} {} {}\n", owner.host, owner.pid, owner.since, owner.job);
}

// Removes what killed processes left: unfinished runs, and unfinished files, which are written only under this lock.
void remove_leftovers(const fs::path& folder, const FileLock&) {
  std::vector<std::string> names;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() && (name.starts_with(temporary_prefix) || name.starts_with(replaced_prefix))) {
      names.push_back(name);
    }
    if (entry.is_regular_file() && name.find(PartialFile::mark) != std::string::npos) files.push_back(entry.path());
  }
  for (const fs::path& file : files) fs::remove(file);
  for (const std::string& name : names) {
    const std::string run = name.substr(temporary_prefix.size());
    const std::optional<FileLock> lock = FileLock::try_lock(lock_path(folder, run));
    if (!lock) continue;  // a living process works on it
    if (name.starts_with(temporary_prefix))
      fs::remove_all(folder / name);
    else
      settle_replaced(folder, run);
  }
}

}  // namespace

std::optional<FileLock> FileLock::try_lock(const fs::path& path) {
  Descriptor file(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
  if (!file.is_open()) throw Error(path.string() + ": cannot be opened: " + std::strerror(errno));
  if (flock(file.get(), LOCK_EX | LOCK_NB) == 0) return FileLock(std::move(file));
  if (errno == EWOULDBLOCK) return std::nullopt;
  throw Error(path.string() + ": cannot be locked: " + std::strerror(errno));
}

void FileLock::write(const std::string& text) const {
  if (ftruncate(file_.get(), 0) != 0 || pwrite(file_.get(), text.data(), text.size(), 0) < 0)
    throw Error(std::string("a lock file cannot be written: ") + std::strerror(errno));
}

Claim::Claim(FileLock lock, fs::path temporary, fs::path final)
    : lock_(std::move(lock)), temporary_(std::move(temporary)), final_(std::move(final)) {
  fs::remove_all(temporary_);
  fs::create_directory(temporary_);
}

Claim::Claim(Claim&& other) noexcept
    : lock_(std::move(other.lock_)), temporary_(std::move(other.temporary_)), final_(std::move(other.final_)) {
  other.temporary_.clear();
}

Claim::~Claim() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
}

void Claim::commit() {
  const fs::path old = final_.parent_path() / (replaced_prefix + final_.filename().string());
  if (fs::exists(final_)) {
    fs::remove_all(old);
    fs::rename(final_, old);
  }
  fs::rename(temporary_, final_);
  temporary_.clear();
  fs::remove_all(old);
}

void check_folder(const fs::path& folder, const Config& config) {
  if (!fs::exists(folder)) return;
  if (!fs::is_directory(folder)) throw UsageError(folder.string() + " is a file; give another --out");
  const fs::path stored = folder / "config.toml";
  if (!fs::exists(stored)) {
    // A process that was killed early may have left some of the files that a results folder begins with.
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      std::string name = entry.path().filename().string();
      if (const std::size_t at = name.find(PartialFile::mark); at != std::string::npos) name.resize(at);
      if (name == ".locks" || name == "published.toml" || name == "plan.json" || name == "config.toml") continue;
      throw UsageError(folder.string() +
                       " exists and is not a results folder; rename the config or give another --out");
    }
    return;
  }
  const std::string remedy = "rename the config, give another --out, or remove that folder";
  std::string theirs;
  try {
    theirs = identity(read_config(stored, ConfigVariant::stored));
  } catch (const Error& error) {
    throw UsageError(folder.string() + " was made from a config that this program cannot read (" + error.what() +
                     "); " + remedy);
  }
  if (theirs != identity(config)) {
    throw UsageError(folder.string() + " holds the results of another config with the name '" + config.name +
                     "' (see its config.toml), and two configs cannot share a folder; " + remedy);
  }
}

namespace {

std::optional<Status> stored_status(const fs::path& folder, const RunRequest& request) {
  const fs::path path = folder / request.run / "run.json";
  if (!fs::exists(path)) return std::nullopt;
  try {
    const RunRecord record = read_record(path);
    if (result_key(record.request) == result_key(request)) return record.status;
  } catch (const Error&) {  // a damaged record counts as none
  }
  return std::nullopt;
}

// Without regard to other processes.
RunState stored_state(const fs::path& folder, const RunRequest& request) {
  const std::optional<Status> status = stored_status(folder, request);
  if (!status) return RunState::missing;
  return *status == Status::ok || *status == Status::skipped ? RunState::done : RunState::retry;
}

// Whether a living process works on a run. The lock is not tried before a run has begun: another process that wants it
// at that moment would fail.
bool being_done(const fs::path& folder, const std::string& run) {
  const fs::path lock = lock_path(folder, run);
  return fs::exists(folder / (temporary_prefix + run)) && fs::exists(lock) && !FileLock::try_lock(lock);
}

}  // namespace

StoredRun stored_run(const fs::path& folder, const RunRequest& request) {
  return {stored_status(folder, request), being_done(folder, request.run)};
}

std::optional<Owner> last_owner(const fs::path& folder, const std::string& run) {
  std::ifstream file(lock_path(folder, run));
  Owner owner;
  if (!(file >> owner.host >> owner.pid >> owner.since)) return std::nullopt;
  file >> owner.job;
  return owner;
}

RunState run_state(const fs::path& folder, const RunRequest& request) {
  const RunState state = stored_state(folder, request);
  if (state == RunState::done) return state;
  return being_done(folder, request.run) ? RunState::elsewhere : state;
}

FileLock lock_results(const fs::path& folder) {
  fs::create_directories(folder / ".locks");  // a copied folder may lack it
  const fs::path path = folder / ".locks" / "store";
  for (int tries = 0; tries < 3600; ++tries) {
    if (std::optional<FileLock> lock = FileLock::try_lock(path)) return std::move(*lock);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  throw Error(path.string() + ": still locked by another process after three minutes; try again later");
}

Report write_report_locked(const fs::path& folder, ReportParts parts) {
  if (!fs::exists(folder / "plan.json")) return write_report(folder, parts);  // throws: it is not a results folder
  const FileLock lock = lock_results(folder);
  return write_report(folder, parts);
}

Store::Store(fs::path folder, const Config& config, const std::vector<RunRequest>& plan) : folder_(std::move(folder)) {
  check_folder(folder_, config);
  const FileLock lock = lock_results(folder_);
  check_folder(folder_, config);  // again, because another process may have made it meanwhile
  remove_leftovers(folder_, lock);
  if (config.published) {
    // Read it completely first: if a stored config is run again, source and target are the same file.
    write_text(folder_ / "published.toml", read_text(*config.published));
  }
  write_text(folder_ / "plan.json", [&plan](std::ostream& file) { write_plan(file, plan); });
  write_text(folder_ / "config.toml", to_toml(config, "published.toml"));
}

RunState Store::state(const RunRequest& request) const { return stored_state(folder_, request); }

std::optional<fs::file_time_type> Store::recorded(const RunRequest& request) const {
  std::error_code error;
  const fs::file_time_type time = fs::last_write_time(folder_ / request.run / "run.json", error);
  return error ? std::nullopt : std::optional(time);
}

std::optional<FileLock> Store::claim_quiet() const {
  return FileLock::try_lock(folder_ / ".locks" / ("timed-" + host_name()));
}

std::optional<Claim> Store::claim(const RunRequest& request) const {
  std::optional<FileLock> lock = FileLock::try_lock(lock_path(folder_, request.run));
  if (!lock) return std::nullopt;
  lock->write(owner_text(this_process()));
  return Claim(std::move(*lock), folder_ / (temporary_prefix + request.run), folder_ / request.run);
}

}  // namespace isobench
