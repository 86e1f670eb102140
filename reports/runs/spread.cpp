#include "isobench/reports/runs/spread.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "isobench/metrics/topology/topology.h"
#include "isobench/reports/text/markdown.h"

namespace isobench {

Runs finished(const Runs& runs) {
  Runs result;
  for (const RunRecord* run : runs) {
    if (run->status == Status::ok && run->measurement) result.push_back(run);
  }
  return result;
}

bool is_closed_manifold(const RunRecord& run) { return run.measurement && is_closed_manifold(*run.measurement); }

bool is_unmatched(const RunRecord& run) { return run.match && !run.match->reason.empty(); }

Runs counted_runs(const Runs& runs) {
  Runs result = finished(runs);
  const auto is_open = [](const RunRecord* run) { return !is_closed_manifold(*run); };
  if (!std::all_of(result.begin(), result.end(), is_open)) std::erase_if(result, is_open);
  return result;
}

Spread spread_of(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    return {nothing, nothing, nothing};
  }
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  const double median = values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
  return {median, values.front(), values.back()};
}

std::string Print::operator()(double value) const {
  if (!std::isfinite(value)) return "–";
  switch (digits) {
    case Digits::significant:
      return significant(value, count);
    case Digits::places:
      return fmt::format("{:.{}f}", value, count);
    case Digits::shortest:
      return fmt::format("{}", value);
  }
  return "–";
}

Print to_significant(int digits) { return {Print::Digits::significant, digits}; }
Print to_places(int places) { return {Print::Digits::places, places}; }
Print as_number() { return {}; }

std::string spread_label(const Runs& runs, bool counted_only) {
  if (runs.size() < 2) return "";
  std::set<std::uint64_t> seeds;
  std::set<int> repeats;
  std::map<std::string, int> unfinished;
  for (const RunRecord* run : runs) {
    seeds.insert(run->request.seed);
    repeats.insert(run->request.repeat);
    if (run->status != Status::ok) ++unfinished[to_string(run->status)];
  }
  std::vector<std::string> words;
  if (seeds.size() > 1) words.push_back(fmt::format("{} seeds", seeds.size()));
  if (repeats.size() > 1) words.push_back(fmt::format("{} repeats", repeats.size()));
  std::string text = fmt::format("{}", fmt::join(words, " × "));
  for (const auto& [status, count] : unfinished)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, status);
  const std::size_t left_out = finished(runs).size() - counted_runs(runs).size();
  if (left_out > 0)
    text += fmt::format("{}{} †{}", text.empty() ? "" : ", ", left_out, counted_only ? " left out" : "");
  return text.empty() ? "" : " (" + text + ")";
}

std::size_t different_meshes(const Runs& runs) {
  std::map<std::uint64_t, std::vector<std::string>> of_seed;
  for (const RunRecord* run : finished(runs)) {
    // Old records have no checksum.
    if (!run->mesh_checksum.empty()) of_seed[run->request.seed].push_back(run->mesh_checksum);
  }
  std::size_t most = 0;
  for (const auto& [seed, checksums] : of_seed) {
    if (checksums.size() < 2) continue;
    most = std::max(most, std::set<std::string>(checksums.begin(), checksums.end()).size());
  }
  return most;
}

}  // namespace isobench
