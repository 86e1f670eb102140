#include <fmt/format.h>

#include <map>

#include "isobench/experiments/cluster/submission.h"
#include "isobench/experiments/command_line/frozen_plan.h"
#include "isobench/experiments/command_line/verbs.h"
#include "isobench/reports/runs/results.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

const std::vector<std::pair<Whereabouts, const char*>>& words() {
  static const std::vector<std::pair<Whereabouts, const char*>> all = {
      {Whereabouts::done, "done"},       {Whereabouts::running, "running"},
      {Whereabouts::waiting, "waiting"}, {Whereabouts::failed, "failed"},
      {Whereabouts::timeout, "timeout"}, {Whereabouts::out_of_memory, "out of memory"},
      {Whereabouts::missing, "missing"}};
  return all;
}

std::string details(const CellState& cell, const fs::path& folder, const RunRequest& request) {
  if (cell.where == Whereabouts::running && cell.owner) {
    const Owner& owner = *cell.owner;
    return fmt::format(" on {}, {}, since {}", owner.host,
                       owner.job.empty() ? fmt::format("process {}", owner.pid) : "job " + owner.job, owner.since);
  }
  if (cell.where == Whereabouts::waiting) return " in task " + cell.task;
  if (cell.where == Whereabouts::missing || cell.where == Whereabouts::done) return "";
  const std::string reason = read_record(folder / request.run / "run.json").reason;
  return ": " + reason.substr(0, reason.find('\n'));
}

}  // namespace

int status_verb(const fs::path& folder, const CommonArguments& common) {
  const std::vector<RunRequest> plan = read_plan(folder);
  const FolderState state = folder_state(folder, plan);
  std::map<Whereabouts, std::size_t> numbers;
  for (const CellState& cell : state.cells) ++numbers[cell.where];
  std::string text;
  for (const auto& [where, word] : words()) {
    if (numbers[where] > 0 || where == Whereabouts::done)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", numbers[where], word);
  }
  fmt::print("{}: {} cells: {}\n", folder.string(), plan.size(), text);
  const std::size_t most = common.verbosity == Verbosity::verbose ? plan.size() : 20;
  for (const auto& [where, word] : words()) {
    const bool listed = where != Whereabouts::done && where != Whereabouts::missing && where != Whereabouts::waiting;
    if (!listed && common.verbosity != Verbosity::verbose) continue;
    std::size_t shown = 0;
    for (std::size_t n = 0; n < plan.size() && shown < most; ++n) {
      if (state.cells[n].where != where) continue;
      fmt::print("  {:8} [{}] {}{}\n", word, n + 1, plan[n].run, details(state.cells[n], folder, plan[n]));
      ++shown;
    }
    if (shown < numbers[where]) fmt::print("  and {} more {} (all: --verbose)\n", numbers[where] - shown, word);
  }
  if (!state.queue_known)
    fmt::print("squeue does not answer here: cells that wait in its queue are counted as missing or failed\n");
  return 0;
}

}  // namespace isobench
