#include "isobench/reports/runs/run_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "isobench/reports/runs/timing.h"

namespace isobench {

namespace {

// Names variants so that no two of one data set have the same name.
class VariantNames {
 public:
  explicit VariantNames(const std::vector<RunRecord>& records) {
    std::map<std::string, std::set<std::string>> sizings;
    for (const RunRecord& record : records) {
      if (record.request.aside) continue;
      const std::string key = record.request.dataset + "/" + record.request.label;
      sizings[key].insert(sizing_name(record.request.sizing));
    }
    for (const auto& [key, values] : sizings) several_sizings_ = several_sizings_ || values.size() > 1;
  }
  std::string operator()(const RunRequest& request) const {
    std::string name = request.label;
    if (several_sizings_) name += ", " + sizing_name(request.sizing);
    return name;
  }

 private:
  bool several_sizings_ = false;
};

}  // namespace

std::string sizing_name(const SizingRequest& sizing) {
  std::string text;
  if (sizing.epsilon) text = fmt::format("ε {}, δ {}", *sizing.epsilon, sizing.delta.value_or(0.0));
  if (sizing.edge_length) text = fmt::format("{} mm", *sizing.edge_length);
  if (sizing.vertices) text = fmt::format("{} vertices", *sizing.vertices);
  return sizing.floor == SizingRequest{}.floor ? text : text + fmt::format(", floor {} voxels", sizing.floor);
}

RunGrid arrange_runs(const Results& results) {
  const VariantNames name_of(results.records);
  RunGrid grid;
  std::set<std::string> known;
  for (const RunRecord& record : results.records) {
    const RunRequest& request = record.request;
    if (request.aside) continue;
    if (known.insert(request.dataset).second) grid.datasets.push_back(request.dataset);
    if (!request.family.empty()) grid.family_of[request.dataset] = request.family;
    const std::string name = name_of(request);
    auto variant = std::find_if(grid.variants.begin(), grid.variants.end(),
                                [&name](const Variant& candidate) { return candidate.name == name; });
    if (variant == grid.variants.end()) {
      variant = grid.variants.insert(variant, Variant{name, request.method, {}});
    }
    variant->runs[request.dataset].push_back(&record);
  }
  grid.timing = usual_timing(grid);
  return grid;
}

bool has_many_datasets(const RunGrid& runs) {
  return std::any_of(runs.variants.begin(), runs.variants.end(),
                     [](const Variant& variant) { return variant.runs.size() >= many_datasets; });
}

std::vector<std::string> families_of(const RunGrid& runs) {
  std::vector<std::string> families;
  std::set<std::string> known;
  for (const std::string& dataset : runs.datasets) {
    const auto family = runs.family_of.find(dataset);
    if (family != runs.family_of.end() && known.insert(family->second).second) families.push_back(family->second);
  }
  return families;
}

std::string opening_dataset(const RunGrid& runs) {
  std::string first;
  std::ptrdiff_t most = 0;
  for (const std::string& dataset : runs.datasets) {
    const auto closed = std::count_if(runs.variants.begin(), runs.variants.end(), [&dataset](const Variant& variant) {
      const RunRecord* run = find_run(variant, dataset);
      return run != nullptr && run->status == Status::ok && is_closed_manifold(*run);
    });
    if (closed <= most) continue;
    most = closed;
    first = dataset;
  }
  return first;
}

const Runs& find_runs(const Variant& variant, const std::string& dataset) {
  static const Runs none;
  const auto found = variant.runs.find(dataset);
  return found == variant.runs.end() ? none : found->second;
}

const RunRecord* find_run(const Variant& variant, const std::string& dataset) {
  const Runs& runs = find_runs(variant, dataset);
  if (runs.empty()) return nullptr;
  const auto done =
      std::find_if(runs.begin(), runs.end(), [](const RunRecord* run) { return run->status == Status::ok; });
  return done == runs.end() ? runs.front() : *done;
}

}  // namespace isobench
