#include "isobench/reports/survey/survey.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "isobench/reports/runs/timing.h"

namespace isobench {

namespace {

using Outcome = std::optional<bool>;

// A run without a mesh does not pass.
Outcome outcome_of(const Check& check, const RunRecord& run) {
  return run.status == Status::ok ? passes(check, run) : Outcome(false);
}

// All must pass; one "no" decides, whatever is unknown besides.
Outcome all_pass(const std::vector<Outcome>& outcomes) {
  Outcome all = true;
  for (const Outcome& outcome : outcomes) {
    if (outcome && !*outcome) return false;
    if (!outcome) all = std::nullopt;
  }
  return all;
}

void count_outcome(const Outcome& outcome, const std::string& dataset, PassCount& count) {
  if (!outcome) {
    ++count.not_measured;
    return;
  }
  ++count.asked;
  if (*outcome)
    ++count.passed;
  else
    count.not_passed.push_back(dataset);
}

bool is_part_of_sound(const Check& check) {
  return check.column == "closed_manifold" || check.column == "right_topology" ||
         check.column == "no_self_intersections";
}

void count_dataset(const Runs& runs, const std::string& dataset, Tally& tally) {
  const auto unfinished =
      std::find_if(runs.begin(), runs.end(), [](const RunRecord* run) { return run->status != Status::ok; });
  ++tally.datasets;
  ++tally.ends[unfinished == runs.end() ? Status::ok : (*unfinished)->status];
  std::vector<Outcome> parts_of_sound;
  for (std::size_t n = 0; n < checks().size(); ++n) {
    std::vector<Outcome> outcomes;
    for (const RunRecord* run : runs) outcomes.push_back(outcome_of(checks()[n], *run));
    const Outcome all = all_pass(outcomes);
    count_outcome(all, dataset, tally.checks[n]);
    if (is_part_of_sound(checks()[n])) parts_of_sound.push_back(all);
  }
  count_outcome(all_pass(parts_of_sound), dataset, tally.sound);
}

bool is_member(const RunGrid& runs, const std::string& dataset, const std::string& family) {
  if (family.empty()) return true;
  const auto found = runs.family_of.find(dataset);
  return found != runs.family_of.end() && found->second == family;
}

}  // namespace

std::vector<const Variant*> surveyed(const RunGrid& runs) {
  std::vector<const Variant*> methods;
  for (const Variant& variant : runs.variants) {
    if (variant.runs.size() >= many_datasets) methods.push_back(&variant);
  }
  return methods;
}

std::vector<std::string> datasets_of(const RunGrid& runs, const Variant& variant, const std::string& family) {
  std::vector<std::string> datasets;
  for (const std::string& dataset : runs.datasets) {
    if (variant.runs.contains(dataset) && is_member(runs, dataset, family)) datasets.push_back(dataset);
  }
  return datasets;
}

Tally tally(const RunGrid& runs, const Variant& variant, const std::string& family) {
  Tally tally;
  tally.checks.resize(checks().size());
  for (const std::string& dataset : datasets_of(runs, variant, family))
    count_dataset(find_runs(variant, dataset), dataset, tally);
  return tally;
}

double value_on(const RunGrid& runs, const Variant& variant, const std::string& dataset, const Criterion& criterion) {
  Runs counted = counted_runs(find_runs(variant, dataset));
  if (criterion.timed) counted = runs_with_timing(counted, runs.timing);
  std::vector<double> values;
  for (const RunRecord* run : counted) values.push_back(criterion.value(*run));
  return spread_of(std::move(values)).median;
}

std::vector<double> values_over(const RunGrid& runs, const Variant& variant, const Criterion& criterion,
                                const std::string& family) {
  std::vector<double> values;
  for (const std::string& dataset : datasets_of(runs, variant, family)) {
    const double value = value_on(runs, variant, dataset, criterion);
    if (std::isfinite(value)) values.push_back(value);
  }
  return values;
}

WorstCase worst_case(const RunGrid& runs, const Variant& variant, const Criterion& criterion,
                     const std::string& family) {
  WorstCase worst;
  for (const std::string& dataset : datasets_of(runs, variant, family)) {
    Runs done = finished(find_runs(variant, dataset));
    if (criterion.timed) done = runs_with_timing(done, runs.timing);
    for (const RunRecord* run : done) {
      const double value = criterion.value(*run);
      if (!std::isfinite(value)) continue;
      const bool worse = criterion.larger ? value < worst.value : value > worst.value;
      if (worst.run == nullptr || worse) worst = {run, value};
    }
  }
  return worst;
}

}  // namespace isobench
