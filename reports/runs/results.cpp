#include "isobench/reports/runs/results.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "isobench/foundation/toml.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

// What the folder of one planned run holds.
struct StoredRun {
  std::optional<RunRecord> record;
  std::string problem;  // what is wrong with a damaged record
};

StoredRun stored_run(const fs::path& folder, const RunRequest& request) {
  const fs::path path = folder / request.run / "run.json";
  if (!fs::exists(path)) return {};
  try {
    StoredRun found{read_record(path), ""};
    // These do not change the result, so the plan decides: a label can be renamed without a new run.
    found.record->request.label = request.label;
    found.record->request.aside = request.aside;
    found.record->request.family = request.family;
    return found;
  } catch (const Error& error) {
    return {std::nullopt, error.what()};
  }
}

// Keeps values that many records share in memory only once. With a hundred thousand records they are most of the data.
class SharedParts {
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

// Without a config in the folder, the folder's name is the title.
std::string title_of(const fs::path& folder, const std::string& name) {
  if (!fs::exists(folder / "config.toml")) return name;
  const std::optional<TomlValue> title = TomlValue::parse_file(folder / "config.toml").find("title");
  return title ? title->as_string() : name;
}

}  // namespace

Results load_results(const fs::path& folder) {
  if (!fs::is_directory(folder) || !fs::exists(folder / "plan.json")) {
    throw DataError(folder.string() +
                    ": not a results folder (plan.json is missing); make one with: isobench run <config>");
  }
  Results results;
  results.name = fs::canonical(folder).filename().string();
  results.title = title_of(folder, results.name);
  std::vector<RunRequest> plan = plan_from_json(read_text(folder / "plan.json"), (folder / "plan.json").string());
  results.records.reserve(plan.size());
  // Records are read in parallel, but in batches: a hundred thousand of them must not be in memory twice.
  constexpr std::size_t batch = 1024;
  SharedParts shared;
  std::vector<StoredRun> found(std::min(batch, plan.size()));
  for (std::size_t start = 0; start < plan.size(); start += batch) {
    const std::size_t count = std::min(batch, plan.size() - start);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t n) { found[n] = stored_run(folder, plan[start + n]); });
    for (std::size_t n = 0; n < count; ++n) {
      if (found[n].record) {
        shared.share(*found[n].record, plan[start + n]);
        results.records.push_back(std::move(*found[n].record));
      } else {
        results.missing.push_back(std::move(plan[start + n]));
      }
      if (!found[n].problem.empty()) results.unreadable.push_back(std::move(found[n].problem));
      plan[start + n] = {};  // frees memory; the record holds the same request
    }
  }
  // The folder may have runs that the plan does not name, of an earlier revision or merged from elsewhere. Reports
  // leave them out.
  if (fs::exists(folder / "published.toml")) results.published = read_published(folder / "published.toml");
  return results;
}

}  // namespace isobench
