#include "reports/results.h"

#include <algorithm>
#include <map>

#include "datasets/toml.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> run_folders(const fs::path& folder) {
  std::vector<fs::path> runs;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    // Names with a dot in front are unfinished or being replaced.
    if (!name.starts_with(".") && entry.is_directory() && fs::exists(entry.path() / "run.json")) {
      runs.push_back(entry.path());
    }
  }
  std::sort(runs.begin(), runs.end());
  return runs;
}

// A folder without its config still has its runs: the name will do.
std::string title_of(const fs::path& folder, const std::string& name) {
  if (!fs::exists(folder / "config.toml")) return name;
  const std::optional<TomlValue> title = TomlValue::parse_file(folder / "config.toml").find("title");
  return title ? title->as_string() : name;
}

}  // namespace

Results load_results(const fs::path& folder) {
  if (!fs::is_directory(folder) || !fs::exists(folder / "plan.json")) {
    throw DataError(folder.string() +
                    ": no results folder (plan.json is missing); make one with: isobench run <config>");
  }
  Results results;
  results.name = fs::canonical(folder).filename().string();
  results.title = title_of(folder, results.name);
  std::map<std::string, RunRecord> found;
  for (const fs::path& run : run_folders(folder)) {
    try {
      found.emplace(run.filename().string(), read_record(run / "run.json"));
    } catch (const Error& error) {
      results.unreadable.emplace_back(error.what());
    }
  }
  for (const RunRequest& request : plan_from_json(read_text(folder / "plan.json"), (folder / "plan.json").string())) {
    const auto record = found.find(request.run);
    if (record == found.end()) {
      results.missing.push_back(request);
      continue;
    }
    // The label is the plan's: renaming one does not make another result.
    record->second.request.label = request.label;
    results.records.push_back(std::move(record->second));
    found.erase(record);
  }
  // Runs of an earlier revision or merged from elsewhere stay in the folder but not in the tables of this plan.
  if (fs::exists(folder / "published.toml")) results.published = read_published(folder / "published.toml");
  return results;
}

}  // namespace isobench
