#include "isobench/experiments/cluster/submission.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "isobench/experiments/cluster/slurm.h"
#include "isobench/experiments/plan/cell_numbers.h"

namespace isobench {

namespace fs = std::filesystem;

namespace {

std::string first_word(const fs::path& path) {
  std::ifstream file(path);
  std::string word;
  file >> word;
  return word;
}

// "123_4" → {"123", 4}; false if the job is not an array.
bool split_task(const std::string& task, std::string& job, std::size_t& index) {
  const std::size_t at = task.find('_');
  if (at == std::string::npos || task.find_first_not_of("0123456789", at + 1) != std::string::npos) return false;
  job = task.substr(0, at);
  index = std::stoul(task.substr(at + 1));
  return true;
}

Whereabouts whereabouts(Status status) {
  switch (status) {
    case Status::ok:
    case Status::skipped:
      return Whereabouts::done;
    case Status::timeout:
      return Whereabouts::timeout;
    case Status::out_of_memory:
      return Whereabouts::out_of_memory;
    case Status::failed:
      break;
  }
  return Whereabouts::failed;
}

CellState cell_state(const fs::path& folder, const RunRequest& request) {
  CellState state;
  const StoredRun stored = stored_run(folder, request);
  if (stored.status) state.where = whereabouts(*stored.status);
  if (stored.elsewhere) {
    state.where = Whereabouts::running;
    state.owner = last_owner(folder, request.run);
  }
  return state;
}

}  // namespace

fs::path slurm_folder(const fs::path& folder) { return folder / ".slurm"; }

std::vector<Submission> submissions(const fs::path& folder, std::size_t cells) {
  std::vector<fs::path> lists;
  if (fs::is_directory(slurm_folder(folder))) {
    for (const auto& entry : fs::directory_iterator(slurm_folder(folder))) {
      if (entry.path().extension() == ".tasks") lists.push_back(entry.path());
    }
  }
  std::sort(lists.begin(), lists.end());
  std::vector<Submission> all;
  for (const fs::path& list : lists) {
    Submission submission;
    submission.job = first_word(fs::path(list).replace_extension(".job"));
    if (submission.job.empty()) continue;  // sbatch refused the array
    std::ifstream file(list);
    for (std::string line; std::getline(file, line);) submission.tasks.push_back(parse_cell_numbers(line, cells));
    all.push_back(std::move(submission));
  }
  return all;
}

FolderState folder_state(const fs::path& folder, const std::vector<RunRequest>& plan) {
  FolderState state;
  state.cells.resize(plan.size());
  tbb::parallel_for(std::size_t{0}, plan.size(), [&](std::size_t n) { state.cells[n] = cell_state(folder, plan[n]); });
  const std::vector<Submission> all = submissions(folder, plan.size());
  if (all.empty()) return state;
  std::vector<std::string> jobs;
  for (const Submission& submission : all) jobs.push_back(submission.job);
  const auto queued = queued_tasks(jobs);
  state.queue_known = queued.has_value();
  if (!queued) return state;
  for (const auto& [task, word] : *queued) {
    std::string job;
    std::size_t index = 0;
    // In all other states, such as COMPLETING, the task is over.
    const bool to_come = word == "PENDING" || word == "CONFIGURING" || word == "RUNNING" || word == "REQUEUED";
    if (!to_come || !split_task(task, job, index)) continue;
    const auto submission =
        std::find_if(all.begin(), all.end(), [&job = job](const Submission& one) { return one.job == job; });
    if (submission == all.end() || index >= submission->tasks.size()) continue;
    for (const std::size_t number : submission->tasks[index]) {
      CellState& cell = state.cells[number - 1];
      if (cell.where == Whereabouts::done || cell.where == Whereabouts::running) continue;
      // A failure may be older than this task, or a result of it. Both count as waiting until the task is over.
      cell.where = Whereabouts::waiting;
      cell.task = task;
    }
  }
  return state;
}

}  // namespace isobench
