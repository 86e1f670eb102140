#include "experiments/runner.h"

#include <fmt/format.h>

#include <csignal>
#include <deque>
#include <fstream>
#include <memory>
#include <thread>

#include "experiments/cell.h"
#include "experiments/child.h"
#include "experiments/plan.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

volatile std::sig_atomic_t stop_signal = 0;
void remember_signal(int signal) { stop_signal = signal; }

// Catches the signals that end a session while runs are going on.
class SignalGuard {
 public:
  SignalGuard() {
    stop_signal = 0;
    struct sigaction action {};
    action.sa_handler = remember_signal;
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &action, &before_[i]);
  }
  ~SignalGuard() {
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
  }
  SignalGuard(const SignalGuard&) = delete;
  SignalGuard& operator=(const SignalGuard&) = delete;

 private:
  static constexpr std::array<int, 3> signals = {SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, 3> before_{};
};

// A cell that is still to be looked at.
struct Pending {
  const RunRequest* request = nullptr;
  std::size_t number = 0;                      // counts from 1, for people
  std::optional<fs::file_time_type> recorded;  // before this process began
  bool again = false;                          // it was left to another process before
};

enum class Start {
  taken,  // under way, or nothing to do
  waits,  // until another process has done with its timed run
  left,   // to another process that is at it
};

struct Active {
  RunRequest request;
  std::string title;
  std::optional<FileLock> quiet;  // of a timed run
  Claim claim;
  Child child;
};

std::string last_lines(const fs::path& log, std::size_t count) {
  std::ifstream file(log, std::ios::binary | std::ios::ate);
  const std::streamoff length = file.tellg();
  file.seekg(std::max<std::streamoff>(0, length - 4096));  // however much a child has written
  std::deque<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    if (line.empty()) continue;
    lines.push_back(line);
    if (lines.size() > count) lines.pop_front();
  }
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : " | ") + line;
  return text;
}

// The record of a run that could not write its own.
RunRecord failure(const Active& active, Status status, const std::string& reason) {
  RunRecord record = begin_record(active.request, 0);
  record.status = status;
  record.reason = reason;
  record.seconds_total = active.child.seconds();
  return record;
}

std::string limit_exceeded(const Active& active, Status& status) {
  const RunRequest& request = active.request;
  if (request.limit_minutes && active.child.seconds() > 60.0 * *request.limit_minutes) {
    status = Status::timeout;
    return fmt::format("not finished after {} minutes", *request.limit_minutes);
  }
  if (request.limit_memory_gb && active.child.peak_memory_gb() > *request.limit_memory_gb) {
    status = Status::failed;
    return fmt::format("out of memory: needed more than {} GB", *request.limit_memory_gb);
  }
  return "";
}

std::string exit_reason(const ChildExit& exit, const fs::path& log) {
  const std::string tail = last_lines(log, 3);
  const std::string after = tail.empty() ? "" : "; its log ends: " + tail;
  if (exit.signal != 0) return "ended by " + signal_name(exit.signal) + after;
  return fmt::format("ended with exit code {} and no record{}", exit.code, after);
}

// What a child that came to its end recorded of its run; where that is nonsense, std::nullopt and why. Its mesh is not
// read here, where a damaged file would cost more than its own run: whoever reads it checks it.
std::optional<RunRecord> recorded_by_child(const Active& active, std::string& reason) {
  const fs::path& folder = active.claim.folder();
  try {
    RunRecord record = record_from_json(read_text(folder / "run.json"), "run.json");
    std::error_code none;
    const bool meshed = fs::is_regular_file(folder / "mesh.vtp") && fs::file_size(folder / "mesh.vtp", none) > 0;
    if (result_key(record.request) != result_key(active.request)) {
      reason = "left the record of another run (" + record.request.run + ")";
    } else if (record.status == Status::ok && !meshed) {
      reason = "recorded as ok without a mesh";
    } else {
      return record;
    }
  } catch (const Error&) {
    reason = "left a run.json that is no run record";
  }
  return std::nullopt;
}

class Runner {
 public:
  Runner(const Store& store, const RunOptions& options, Console& console, std::size_t total)
      : store_(store), options_(options), console_(console), total_(total) {}

  RunSummary run(const std::vector<RunRequest>& cells) {
    const SignalGuard guard;
    for (const RunRequest& cell : cells) pending_.push_back({&cell, pending_.size() + 1, store_.recorded(cell)});
    while (stop_signal == 0 && (!pending_.empty() || !active_.empty())) {
      while (stop_signal == 0 && !pending_.empty() && room_for(pending_.front()) && begin_next()) {
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      for (std::size_t i = 0; i < active_.size() && stop_signal == 0;) {
        if (step(*active_[i]))
          active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(i));
        else
          ++i;
      }
      show();
    }
    console_.clear();
    summary_.interrupted = stop_signal != 0;
    active_.clear();  // kills the children, then removes their folders
    return summary_;
  }

 private:
  // A timed run has the machine to itself, as far as this program goes. What was left to another process is looked at
  // again when all else is done: that process may have been killed.
  bool room_for(const Pending& next) const {
    if (active_.empty()) return true;
    if (next.again || next.request->alone || active_.front()->request.alone) return false;
    return active_.size() < static_cast<std::size_t>(options_.jobs);
  }

  // False where the next cell has to wait for another process.
  bool begin_next() {
    Pending next = pending_.front();
    const Start result = start(next);
    if (result == Start::waits) return false;
    pending_.pop_front();
    if (result == Start::left) {
      next.again = true;
      pending_.push_back(next);
    }
    return true;
  }

  // Whether there is nothing to do for a run: it was done before or, while this process was at others, by another.
  bool settled(const Pending& next) {
    const RunState state = store_.state(*next.request);
    const bool meanwhile = state != RunState::missing && store_.recorded(*next.request) != next.recorded;
    if (!meanwhile && (options_.force || state != RunState::done)) return false;
    ++(state == RunState::done ? summary_.reused : summary_.elsewhere);
    console_.detail(fmt::format("{}: {}", title_of(next), meanwhile ? "done by another process" : "done before"));
    return true;
  }

  std::string title_of(const Pending& next) const {
    const RunRequest& request = *next.request;
    const std::string repeat = request.repeat > 1 ? fmt::format(" r{}", request.repeat) : "";
    return fmt::format("[{}/{}] {}/{} {} s{}{}", next.number, total_, request.dataset, request.label,
                       sizing_text(request.sizing), request.seed, repeat);
  }

  Start start(const Pending& next) {
    if (settled(next)) return Start::taken;
    const RunRequest& request = *next.request;
    const std::string title = title_of(next);
    std::optional<FileLock> quiet = request.alone ? store_.claim_quiet() : std::nullopt;
    if (request.alone && !quiet) {
      console_.update(title + ": waits for a timed run of another process", -1.0);
      return Start::waits;
    }
    std::optional<Claim> claim = store_.claim(request);
    if (!claim && !next.again) return Start::left;
    if (!claim) {
      ++summary_.elsewhere;
      console_.line(title + ": left to another process that is at it");
      return Start::taken;
    }
    // Between looking and claiming another process may have finished it.
    if (settled(next)) return Start::taken;
    Child child({options_.program.string(), "cell", "--plan", (store_.folder() / "plan.json").string(), "--run",
                 request.run, "--folder", claim->folder().string(), "--threads", std::to_string(options_.threads)},
                claim->folder() / "log.txt");
    console_.detail(title + ": started");
    active_.push_back(
        std::make_unique<Active>(Active{request, title, std::move(quiet), std::move(*claim), std::move(child)}));
    return Start::taken;
  }

  // True once the run is over and stored.
  bool step(Active& active) {
    const double seconds = active.child.seconds();
    if (const std::optional<ChildExit> exit = active.child.poll()) {
      std::optional<RunRecord> record;
      std::string reason;
      if (exit->signal != 0 || !fs::is_regular_file(active.claim.folder() / "run.json"))
        reason = exit_reason(*exit, active.claim.folder() / "log.txt");
      else
        record = recorded_by_child(active, reason);
      if (record && exit->code == 3) ++summary_.data;
      store(active, record ? *record : failure(active, Status::failed, reason), record.has_value(), seconds);
      return true;
    }
    Status status = Status::failed;
    const std::string reason = limit_exceeded(active, status);
    if (reason.empty()) return false;
    const RunRecord record = failure(active, status, reason);
    active.child.kill();
    store(active, record, false, seconds);
    return true;
  }

  void store(Active& active, const RunRecord& record, bool recorded, double seconds) {
    if (!recorded) {
      // Whatever there is of them may be half of one.
      fs::remove_all(active.claim.folder() / "mesh.vtp");
      fs::remove_all(active.claim.folder() / "run.json");
      write_record(record, active.claim.folder() / "run.json");
    }
    active.claim.commit();
    const bool fine = record.status == Status::ok || record.status == Status::skipped;
    if (record.status == Status::ok)
      ++summary_.ok;
    else if (record.status == Status::skipped)
      ++summary_.skipped;
    else
      ++summary_.failed;
    const std::string word = fine ? console_.good(to_string(record.status)) : console_.bad(to_string(record.status));
    console_.line(fmt::format("{}: {}{}, {:.1f} s", active.title, word,
                              record.reason.empty() ? "" : " (" + record.reason + ")", seconds));
  }

  void show() {
    if (active_.empty()) return;
    Active& first = *active_.front();
    const ChildProgress& progress = first.child.progress();
    for (const auto& active : active_) active->child.progress();  // keeps every pipe from filling
    const std::string more = active_.size() > 1 ? fmt::format(" (and {} more)", active_.size() - 1) : "";
    console_.update(fmt::format("{}  {}  {:.0f} s{}", first.title, progress.stage, first.child.seconds(), more),
                    progress.fraction);
  }

  const Store& store_;
  const RunOptions& options_;
  Console& console_;
  std::size_t total_;
  RunSummary summary_;
  std::deque<Pending> pending_;
  std::vector<std::unique_ptr<Active>> active_;
};

}  // namespace

RunSummary run_cells(const Store& store, const std::vector<RunRequest>& cells, const RunOptions& options,
                     Console& console) {
  return Runner(store, options, console, cells.size()).run(cells);
}

}  // namespace isobench
