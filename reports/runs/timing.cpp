#include "isobench/reports/runs/timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace isobench {

namespace {

struct TimingCount {
  std::string timing;
  std::size_t runs = 0;
};

std::vector<TimingCount> timing_counts(const RunGrid& runs) {
  std::vector<TimingCount> found;
  for (const Variant& variant : runs.variants) {
    for (const std::string& dataset : runs.datasets) {
      for (const RunRecord* run : finished(find_runs(variant, dataset))) {
        const std::string timing = timing_of(*run);
        auto known = std::find_if(found.begin(), found.end(),
                                  [&timing](const TimingCount& count) { return count.timing == timing; });
        if (known == found.end()) known = found.insert(found.end(), {timing, 0});
        ++known->runs;
      }
    }
  }
  return found;
}

}  // namespace

std::string timing_of(const RunRecord& record) {
  const Environment& here = record.environment;
  return fmt::format("{}, {} cores, {} threads{}", here.cpu, here.cores, record.threads,
                     here.exclusive ? ", nothing else on the machine" : "");
}

std::string usual_timing(const RunGrid& runs) {
  const std::vector<TimingCount> all = timing_counts(runs);
  const auto most = std::max_element(all.begin(), all.end(),
                                     [](const TimingCount& a, const TimingCount& b) { return a.runs < b.runs; });
  return most == all.end() ? "" : most->timing;
}

Runs runs_with_timing(const Runs& runs, const std::string& timing) {
  Runs same;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(same),
               [&timing](const RunRecord* run) { return timing_of(*run) == timing; });
  return same;
}

std::string timing_remark(const RunGrid& runs) {
  std::vector<std::string> others;
  for (const TimingCount& count : timing_counts(runs)) {
    if (count.timing != runs.timing)
      others.push_back(fmt::format("{} run{} on {}", count.runs, count.runs == 1 ? "" : "s", count.timing));
  }
  if (others.empty()) return "";
  return fmt::format("§ Seconds are compared only between runs on {}. Left out: {}.", runs.timing,
                     fmt::join(others, "; "));
}

}  // namespace isobench
