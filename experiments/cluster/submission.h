// What was handed to a scheduler, kept in the results folder: FOLDER/.slurm/<number>.tasks has one line of cell numbers
// a task, <number>.job the job that they went to.
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
  std::vector<std::vector<std::size_t>> tasks;  ///< numbers of cells, by task from 0
};

/// Folder of the scripts, lists and logs.
std::filesystem::path slurm_folder(const std::filesystem::path& folder);

/// Every array that was submitted for a results folder, those that are over included.
std::vector<Submission> submissions(const std::filesystem::path& folder, std::size_t cells);

/// Where a cell is.
enum class Whereabouts { done, failed, timeout, out_of_memory, running, waiting, missing };

struct CellState {
  Whereabouts where = Whereabouts::missing;
  std::string task;            ///< of the scheduler, where it is waiting in one
  std::optional<Owner> owner;  ///< of a running one
};

/// Of every cell of the plan, in its order: from the records, from the locks and, where there is a squeue, from that.
/// A cell that failed and waits in a queue again is waiting.
struct FolderState {
  std::vector<CellState> cells;
  bool queue_known = true;  ///< false where squeue could not be asked: what waits is among the missing or failed then
};
FolderState folder_state(const std::filesystem::path& folder, const std::vector<RunRequest>& plan);

}  // namespace isobench
