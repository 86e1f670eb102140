#include "isobench/experiments/runner/runner.h"

#include <fmt/format.h>

#include <chrono>
#include <list>
#include <memory>
#include <set>
#include <thread>

#include "isobench/experiments/plan/plan.h"
#include "isobench/experiments/runner/cell.h"
#include "isobench/experiments/runner/cell_outcome.h"
#include "isobench/experiments/runner/cell_process.h"
#include "isobench/experiments/runner/stop_signals.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

const std::string own_plan = "request.json";  // in the temporary folder of a run

// Removes the scratch folders of a run that was stopped before it could remove them itself.
void remove_scratch(const fs::path& folder) {
  std::vector<fs::path> scratch;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().filename().string().starts_with(".")) scratch.push_back(entry.path());
  }
  for (const fs::path& path : scratch) fs::remove_all(path);
}

// A cell that has not been started or settled yet.
struct Pending {
  const RunRequest* request = nullptr;
  std::size_t number = 0;                      // in the plan, from 1; shown to the user
  std::optional<fs::file_time_type> recorded;  // time of its record when this process began
  bool again = false;                          // another process was working on it when it was tried first
};

enum class Start {
  taken,  // it runs now, or there is nothing to do
  waits,  // until another process ends a timed run, or the run that others are matched to
  left,   // another process is working on it; try again later
};

struct Active {
  RunRequest request;
  std::string title;
  std::optional<FileLock> quiet;  // of a timed run
  Claim claim;
  CellProcess child;
};

class Runner {
 public:
  Runner(const Store& store, const RunOptions& options, Console& console, std::size_t total)
      : store_(store), options_(options), console_(console), total_(total) {}

  RunSummary run(const std::vector<RunRequest>& cells) {
    const StopSignals guard;
    for (const RunRequest& cell : cells) {
      pending_.push_back({&cell, pending_.size() + 1, store_.recorded(cell)});
      unfinished_.insert(cell.run);
    }
    while (!StopSignals::arrived() && (!pending_.empty() || !active_.empty())) {
      start_what_can();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      for (std::size_t i = 0; i < active_.size() && !StopSignals::arrived();) {
        if (step(*active_[i]))
          active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(i));
        else
          ++i;
      }
      show();
    }
    console_.clear();
    summary_.interrupted = StopSignals::arrived();
    active_.clear();  // kills the children, then removes their folders
    return summary_;
  }

 private:
  // Starts cells in their order, except those that wait for the run that they are matched to or for another process.
  void start_what_can() {
    for (auto next = pending_.begin(); next != pending_.end() && !StopSignals::arrived();) {
      if (!room_for(*next->request)) return;
      // Cells of other processes are tried again when nothing else is left: the other process may have been killed.
      const bool later = next->again && !active_.empty();
      if (later || unfinished_.count(next->request->match_to) > 0) {
        ++next;
        continue;
      }
      switch (start(*next)) {
        case Start::taken:
          next = pending_.erase(next);
          break;
        case Start::left:
          next->again = true;
          pending_.splice(pending_.end(), pending_, next++);
          break;
        case Start::waits:
          if (!next->again) return;
          ++next;
          break;
      }
    }
  }

  // This program runs nothing else at the same time as a timed run.
  bool room_for(const RunRequest& request) const {
    if (active_.empty()) return true;
    if (request.alone || active_.front()->request.alone) return false;
    return active_.size() < static_cast<std::size_t>(options_.jobs);
  }

  // Whether a pending run is matched to this one.
  bool needed(const RunRequest& request) const {
    return std::any_of(pending_.begin(), pending_.end(),
                       [&request](const Pending& other) { return other.request->match_to == request.run; });
  }

  // The number of vertices to match; std::nullopt if the other run has no mesh.
  std::optional<double> match_vertices(const RunRequest& request) const {
    if (request.match_to.empty()) return std::nullopt;
    const fs::path path = store_.folder() / request.match_to / "run.json";
    if (!fs::exists(path)) return std::nullopt;
    try {
      const RunRecord record = read_record(path);
      if (record.measurement) return record.measurement->figure("vertices");
    } catch (const DataError&) {  // a damaged record counts as none
    }
    return std::nullopt;
  }

  // Whether there is nothing to do: the run was done before, or meanwhile by another process. If so, counts it.
  bool settled(const Pending& next) {
    const RunState state = store_.state(*next.request);
    const bool meanwhile = state != RunState::missing && store_.recorded(*next.request) != next.recorded;
    if (!meanwhile && (options_.force || state != RunState::done)) return false;
    ++(state == RunState::done ? summary_.reused : summary_.elsewhere);
    unfinished_.erase(next.request->run);
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
    if (!claim && needed(request)) {
      console_.update(title + ": waits for another process that is working on it", -1.0);
      return Start::waits;
    }
    if (!claim) {
      ++summary_.elsewhere;
      unfinished_.erase(request.run);
      console_.line(title + ": left to another process that is working on it");
      return Start::taken;
    }
    // Another process may have finished it before the claim.
    if (settled(next)) return Start::taken;
    const std::optional<double> vertices = match_vertices(request);
    if (!request.match_to.empty() && !vertices) {
      store_without_reference(request, title, std::move(*claim));
      return Start::taken;
    }
    // A plan of one run, so that a child need not read a plan of a hundred thousand.
    write_text(claim->folder() / own_plan, plan_to_json({request}));
    std::vector<std::string> command = {options_.program.string(),
                                        "cell",
                                        "--plan",
                                        (claim->folder() / own_plan).string(),
                                        "--run",
                                        request.run,
                                        "--folder",
                                        claim->folder().string(),
                                        "--threads",
                                        std::to_string(options_.threads)};
    if (vertices) command.insert(command.end(), {"--match-vertices", fmt::format("{}", *vertices)});
    CellProcess child(std::move(command), claim->folder() / "log.txt");
    console_.detail(title + ": started");
    active_.push_back(
        std::make_unique<Active>(Active{request, title, std::move(quiet), std::move(*claim), std::move(child)}));
    return Start::taken;
  }

  // The run cannot be matched. It is stored as failed, so that it is tried again once the other run has a mesh.
  void store_without_reference(const RunRequest& request, const std::string& title, Claim claim) {
    RunRecord record = begin_record(request, 0);
    record.reason = "cannot be matched: " + request.match_to + " has no mesh";
    write_record(record, claim.folder() / "run.json");
    claim.commit();
    conclude(record, title, 0.0);
  }

  // Looks after an active run. Returns true once it is over and stored.
  bool step(Active& active) {
    const double seconds = active.child.seconds();
    if (const std::optional<ChildExit> exit = active.child.poll()) {
      const CellOutcome end = outcome_of(active.request, *exit, seconds, active.claim.folder());
      if (end.own && exit->code == 3) ++summary_.data;
      store(active, end.record, end.own, seconds);
      return true;
    }
    const std::optional<RunRecord> record = beyond_limits(active.request, active.child);
    if (!record) return false;
    active.child.kill();
    store(active, *record, false, seconds);
    return true;
  }

  void store(Active& active, const RunRecord& record, bool recorded, double seconds) {
    if (!recorded) {
      // What the child has left may be incomplete.
      fs::remove_all(active.claim.folder() / "mesh.vtp");
      fs::remove_all(active.claim.folder() / "run.json");
      remove_scratch(active.claim.folder());
      write_record(record, active.claim.folder() / "run.json");
    }
    fs::remove(active.claim.folder() / own_plan);
    active.claim.commit();
    conclude(record, active.title, seconds);
  }

  // Counts a run that was stored and tells the user.
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

  // "5 done, 1 failed, 3 to go, about 4 min left". The estimate takes the average time of the runs of this process.
  std::string state() const {
    const int run_here = summary_.ok + summary_.skipped + summary_.failed;
    std::string text = fmt::format("{} done", summary_.ok + summary_.skipped + summary_.reused);
    if (summary_.failed > 0) text += fmt::format(", {} failed", summary_.failed);
    text += fmt::format(", {} to go", unfinished_.size());
    if (run_here == 0) return text;
    const std::chrono::duration<double> so_far = std::chrono::steady_clock::now() - begun_;
    const double left = so_far.count() / run_here * static_cast<double>(unfinished_.size());
    return text + (left < 90.0 ? fmt::format(", about {:.0f} s left", left)
                               : fmt::format(", about {:.0f} min left", left / 60.0));
  }

  void show() {
    if (active_.empty()) return;
    Active& first = *active_.front();
    const CellProgress& progress = first.child.progress();
    for (const auto& active : active_)
      active->child.progress();  // empties every pipe: a line written to a full one is lost
    const std::string more = active_.size() > 1 ? fmt::format(" (and {} more)", active_.size() - 1) : "";
    console_.update(
        fmt::format("{}  {}  {:.0f} s{}; {}", first.title, progress.stage, first.child.seconds(), more, state()),
        progress.fraction);
  }

  const Store& store_;
  const RunOptions& options_;
  Console& console_;
  std::size_t total_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  RunSummary summary_;
  std::list<Pending> pending_;
  std::set<std::string> unfinished_;  // names of the pending and the active runs
  std::vector<std::unique_ptr<Active>> active_;
};

}  // namespace

RunSummary run_cells(const Store& store, const std::vector<RunRequest>& cells, const RunOptions& options,
                     Console& console) {
  return Runner(store, options, console, cells.size()).run(cells);
}

}  // namespace isobench
