#include "experiments/runner.h"

#include <fmt/format.h>

#include <csignal>
#include <deque>
#include <fstream>
#include <list>
#include <map>
#include <memory>
#include <set>
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

struct Active {
  RunRequest request;
  std::string title;
  std::optional<FileLock> quiet;  // of a timed run
  Claim claim;
  Child child;
};

std::string last_lines(const fs::path& log, std::size_t count) {
  std::ifstream file(log);
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
    status = Status::out_of_memory;
    return fmt::format("needed more than {} GB", *request.limit_memory_gb);
  }
  return "";
}

std::string exit_reason(const ChildExit& exit, const fs::path& log) {
  const std::string tail = last_lines(log, 3);
  const std::string after = tail.empty() ? "" : "; its log ends: " + tail;
  if (exit.signal != 0) return "ended by " + signal_name(exit.signal) + after;
  return fmt::format("ended with exit code {} and no record{}", exit.code, after);
}

class Runner {
 public:
  Runner(const Store& store, const RunOptions& options, Console& console, std::size_t total)
      : store_(store), options_(options), console_(console), total_(total) {}

  RunSummary run(const std::vector<RunRequest>& cells) {
    const SignalGuard guard;
    for (const RunRequest& request : cells) {
      requests_.emplace(request.run, &request);
      unfinished_.insert(request.run);
      waiting_.push_back(&request);
    }
    while (stop_signal == 0 && (!waiting_.empty() || !active_.empty())) {
      start_what_can();
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
  // In their order, but for those that wait for the run that they are matched to.
  void start_what_can() {
    for (auto request = waiting_.begin(); request != waiting_.end() && stop_signal == 0;) {
      if (!room_for(**request)) return;
      if (waits_for_match(**request)) {
        ++request;
        continue;
      }
      if (!start(**request)) return;
      request = waiting_.erase(request);
    }
  }

  // A timed run has the machine to itself, as far as this program goes.
  bool room_for(const RunRequest& request) const {
    if (active_.empty()) return true;
    if (request.alone || active_.front()->request.alone) return false;
    return active_.size() < static_cast<std::size_t>(options_.jobs);
  }

  // Whether the run that this one is matched to is still to come, here or in another process.
  bool waits_for_match(const RunRequest& request) {
    if (request.match_to.empty()) return false;
    if (unfinished_.count(request.match_to) > 0) return true;
    const auto other = requests_.find(request.match_to);
    if (other == requests_.end() || run_state(store_.folder(), *other->second) != RunState::elsewhere) return false;
    console_.update(request.run + ": waits for another process, which is at " + request.match_to, -1.0);
    return true;
  }

  // The number of vertices to match; std::nullopt where the other run has no mesh.
  std::optional<double> match_vertices(const RunRequest& request) const {
    const fs::path path = store_.folder() / request.match_to / "run.json";
    if (!fs::exists(path)) return std::nullopt;
    try {
      const RunRecord record = read_record(path);
      if (record.measurement) return static_cast<double>(record.measurement->vertices);
    } catch (const DataError&) {  // damaged: as good as none
    }
    return std::nullopt;
  }

  std::string title_of(const RunRequest& request) const {
    const std::string repeat = request.repeat > 1 ? fmt::format(" r{}", request.repeat) : "";
    return fmt::format("[{}/{}] {}/{} {} s{}{}", started_ + 1, total_, request.dataset, request.label,
                       sizing_text(request.sizing), request.seed, repeat);
  }

  // True once it is under way, or need not be; false where it has to wait for another process.
  bool start(const RunRequest& request) {
    const std::string title = title_of(request);
    const bool timed = request.alone && (options_.force || store_.state(request) != RunState::done);
    std::optional<FileLock> quiet = timed ? store_.claim_quiet() : std::nullopt;
    if (timed && !quiet) {
      console_.update(title + ": waits for a timed run of another process", -1.0);
      return false;
    }
    ++started_;
    if (reuse(request, title)) return true;
    std::optional<Claim> claim = store_.claim(request);
    if (!claim) {
      ++summary_.elsewhere;
      unfinished_.erase(request.run);
      console_.line(title + ": left to another process that is at it");
      return true;
    }
    // Between looking and claiming another process may have finished it.
    if (reuse(request, title)) return true;
    const std::optional<double> vertices = match_vertices(request);
    if (!request.match_to.empty() && !vertices) {
      store_without_reference(request, title, std::move(*claim));
      return true;
    }
    std::vector<std::string> command = {options_.program.string(),
                                        "cell",
                                        "--plan",
                                        (store_.folder() / "plan.json").string(),
                                        "--run",
                                        request.run,
                                        "--folder",
                                        claim->folder().string(),
                                        "--threads",
                                        std::to_string(options_.threads)};
    if (vertices) command.insert(command.end(), {"--match-vertices", fmt::format("{}", *vertices)});
    Child child(std::move(command), claim->folder() / "log.txt");
    console_.detail(title + ": started");
    active_.push_back(
        std::make_unique<Active>(Active{request, title, std::move(quiet), std::move(*claim), std::move(child)}));
    return true;
  }

  bool reuse(const RunRequest& request, const std::string& title) {
    if (options_.force || store_.state(request) != RunState::done) return false;
    ++summary_.reused;
    unfinished_.erase(request.run);
    console_.detail(title + ": done before");
    return true;
  }

  // Nothing to match it to: failed, so that it is tried again once there is.
  void store_without_reference(const RunRequest& request, const std::string& title, Claim claim) {
    RunRecord record = begin_record(request, 0);
    record.reason = "cannot be matched: " + request.match_to + " has no mesh";
    write_record(record, claim.folder() / "run.json");
    claim.commit();
    conclude(record, title, 0.0);
  }

  // True once the run is over and stored.
  bool step(Active& active) {
    const double seconds = active.child.seconds();
    if (const std::optional<ChildExit> exit = active.child.poll()) {
      const fs::path path = active.claim.folder() / "run.json";
      const bool recorded = exit->signal == 0 && fs::exists(path);
      const RunRecord record =
          recorded ? read_record(path)
                   : failure(active, Status::failed, exit_reason(*exit, active.claim.folder() / "log.txt"));
      if (exit->code == 3) ++summary_.data;
      store(active, record, recorded, seconds);
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
      fs::remove(active.claim.folder() / "mesh.vtp");  // whatever there is of it may be half a mesh
      write_record(record, active.claim.folder() / "run.json");
    }
    active.claim.commit();
    conclude(record, active.title, seconds);
  }

  // A run that is stored now: counted and said.
  void conclude(const RunRecord& record, const std::string& title, double seconds) {
    unfinished_.erase(record.request.run);
    const bool fine = record.status == Status::ok || record.status == Status::skipped;
    if (record.status == Status::ok)
      ++summary_.ok;
    else if (record.status == Status::skipped)
      ++summary_.skipped;
    else
      ++summary_.failed;
    const std::string word = fine ? console_.good(to_string(record.status)) : console_.bad(to_string(record.status));
    console_.line(fmt::format("{}: {}{}, {:.1f} s", title, word,
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
  std::size_t started_ = 0;
  std::map<std::string, const RunRequest*> requests_;  // by name
  std::set<std::string> unfinished_;                   // those that are waiting or active here
  std::list<const RunRequest*> waiting_;
  RunSummary summary_;
  std::vector<std::unique_ptr<Active>> active_;
};

}  // namespace

RunSummary run_cells(const Store& store, const std::vector<RunRequest>& cells, const RunOptions& options,
                     Console& console) {
  return Runner(store, options, console, cells.size()).run(cells);
}

}  // namespace isobench
