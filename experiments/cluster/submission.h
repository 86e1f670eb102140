// The job arrays that were submitted for a results folder. FOLDER/.slurm/<number>.tasks has a line of cell numbers for
// each task, and <number>.job has the number of the job.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "isobench/experiments/runner/store.h"

namespace isobench {

struct Submission {
  std::string job;
  std::vector<std::vector<std::size_t>> tasks;  ///< the cell numbers of each task
};

/// The folder of the scripts, lists and logs.
std::filesystem::path slurm_folder(const std::filesystem::path& folder);

/// Every array that was submitted for a results folder, whether it is over or not. `cells`: the size of the plan.
std::vector<Submission> submissions(const std::filesystem::path& folder, std::size_t cells);

/// The state of a cell.
enum class Whereabouts { done, failed, timeout, out_of_memory, running, waiting, missing };

struct CellState {
  Whereabouts where = Whereabouts::missing;
  std::string task;            ///< the task of the scheduler in which it waits
  std::optional<Owner> owner;  ///< the process that runs it
};

/// The states of all cells in the order of the plan, from the records, the locks and, if it works, squeue. A failed
/// cell that is queued again counts as waiting.
struct FolderState {
  std::vector<CellState> cells;
  bool queue_known = true;  ///< false if squeue failed: waiting cells then count as missing or failed
};
FolderState folder_state(const std::filesystem::path& folder, const std::vector<RunRequest>& plan);

}  // namespace isobench
