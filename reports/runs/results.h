// A results folder read back: everything that reports are made from.
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
  std::string name;                     ///< of the experiment: the folder's
  std::string title;                    ///< as its config says it
  std::vector<RunRequest> missing;      ///< planned, but no record yet
  std::vector<RunRecord> records;       ///< in the order of the plan, then by name
  std::vector<std::string> unreadable;  ///< a sentence for each record that is damaged
  std::optional<Published> published;
};

/// Reads a results folder. A damaged record costs only itself: it is named in `unreadable`.
/// Throws DataError where `folder` is no results folder.
Results load_results(const std::filesystem::path& folder);

}  // namespace isobench
