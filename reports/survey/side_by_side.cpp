#include "isobench/reports/survey/side_by_side.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isobench {

namespace {

bool has_closed_manifold(const Variant& variant, const std::string& dataset) {
  const Runs& runs = find_runs(variant, dataset);
  return std::any_of(runs.begin(), runs.end(),
                     [](const RunRecord* run) { return run->status == Status::ok && is_closed_manifold(*run); });
}

// NaN if the value is not known although there is a mesh.
double cost_on(const RunGrid& runs, const Variant& variant, const std::string& dataset, const Criterion& criterion) {
  if (!has_closed_manifold(variant, dataset)) return std::numeric_limits<double>::infinity();
  const double value = value_on(runs, variant, dataset, criterion);
  return criterion.larger ? 1.0 / value : value;
}

}  // namespace

std::vector<std::string> shared_datasets(const RunGrid& runs) {
  const std::vector<const Variant*> methods = surveyed(runs);
  std::vector<std::string> shared;
  for (const std::string& dataset : runs.datasets) {
    const bool all = std::all_of(methods.begin(), methods.end(),
                                 [&dataset](const Variant* method) { return method->runs.contains(dataset); });
    if (all && !methods.empty()) shared.push_back(dataset);
  }
  return shared;
}

SideBySide side_by_side(const RunGrid& runs, const Criterion& criterion) {
  SideBySide side;
  side.methods = surveyed(runs);
  if (side.methods.size() < 2) return {};
  side.costs.resize(side.methods.size());
  for (const std::string& dataset : shared_datasets(runs)) {
    std::vector<double> here;
    for (const Variant* method : side.methods) here.push_back(cost_on(runs, *method, dataset, criterion));
    if (std::any_of(here.begin(), here.end(), [](double cost) { return std::isnan(cost); })) continue;
    side.datasets.push_back(dataset);
    for (std::size_t m = 0; m < here.size(); ++m) side.costs[m].push_back(here[m]);
  }
  return side.datasets.size() < many_datasets ? SideBySide{} : side;
}

}  // namespace isobench
