#include "isobench/reports/runs/results.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "isobench/foundation/toml.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

// One planned run as it is found in its folder.
struct Found {
  std::optional<RunRecord> record;
  std::string problem;  // with a record that is damaged
};

Found find(const fs::path& folder, const RunRequest& request) {
  const fs::path path = folder / request.run / "run.json";
  if (!fs::exists(path)) return {};
  try {
    Found found{read_record(path), ""};
    // What is no part of the result is the plan's: renaming a label does not make another one.
    found.record->request.label = request.label;
    found.record->request.aside = request.aside;
    return found;
  } catch (const Error& error) {
    return {std::nullopt, error.what()};
  }
}

// What records have in common with each other is held once: of a hundred thousand it is most of what there is.
class Common {
 public:
  void share(RunRecord& record, const RunRequest& planned) {
    if (record.request.parameters == planned.parameters) record.request.parameters = planned.parameters;
    record.environment.libraries = libraries_.first_of(record.environment.libraries);
    record.counters.share_names(names_);
  }

 private:
  SharedPool<LibraryVersions> libraries_;
  SharedPool<NamedNumbers::Names> names_;
};

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
  std::vector<RunRequest> plan = plan_from_json(read_text(folder / "plan.json"), (folder / "plan.json").string());
  results.records.reserve(plan.size());
  // Side by side, but a hundred thousand records are not to be held twice.
  constexpr std::size_t batch = 1024;
  Common common;
  std::vector<Found> found(std::min(batch, plan.size()));
  for (std::size_t start = 0; start < plan.size(); start += batch) {
    const std::size_t count = std::min(batch, plan.size() - start);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t n) { found[n] = find(folder, plan[start + n]); });
    for (std::size_t n = 0; n < count; ++n) {
      if (found[n].record) {
        common.share(*found[n].record, plan[start + n]);
        results.records.push_back(std::move(*found[n].record));
      } else {
        results.missing.push_back(std::move(plan[start + n]));
      }
      if (!found[n].problem.empty()) results.unreadable.push_back(std::move(found[n].problem));
      plan[start + n] = {};  // its record says the same: both at once would be too much
    }
  }
  // Runs of an earlier revision or merged from elsewhere stay in the folder but not in the tables of this plan.
  if (fs::exists(folder / "published.toml")) results.published = read_published(folder / "published.toml");
  return results;
}

}  // namespace isobench
