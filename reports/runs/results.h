// A results folder, read back. All reports are made from it.
//
//   results/<experiment>/config.toml, plan.json, published.toml
//   results/<experiment>/<run>/run.json, mesh.vtp, log.txt
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isobench/reports/published/published.h"
#include "isobench/reports/record/record.h"

namespace isobench {

struct Results {
  std::string name;                     ///< of the experiment, which is the folder's name
  std::string title;                    ///< from the config
  std::vector<RunRequest> missing;      ///< planned runs that have no readable record yet
  std::vector<RunRecord> records;       ///< in the order of the plan
  std::vector<std::string> unreadable;  ///< one sentence for each damaged record
  std::optional<Published> published;
};

/// Reads a results folder. A damaged record does not stop the others from being read; `unreadable` names it.
/// Throws DataError if `folder` is not a results folder.
Results load_results(const std::filesystem::path& folder);

}  // namespace isobench
