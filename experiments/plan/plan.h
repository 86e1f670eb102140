// Which runs an experiment consists of.
#pragma once

#include <string>
#include <vector>

#include "isobench/experiments/plan/config.h"
#include "isobench/reports/record/record.h"

namespace isobench {

/// Every run of a config, datasets outermost: each combination of dataset, method entry, its parameters, sampling,
/// reference k, seed and repeat, that base once and then once more for each value of each [[vary]], no run twice. Needs
/// no data: checksums are of what the catalogue declares. Throws UsageError for two entries that are one run.
std::vector<RunRequest> make_plan(const Config& config);

/// Everything that determines a run's result, as text: dataset and its checksum, method and its revision, parameters,
/// sizing, seed, repeat, reference k, the metrics' revision. Limits, label and threads do not.
std::string result_key(const RunRequest& request);

/// "skull-particles-e0.5-d0.3-s1-1f2a9c3e": the tail is a hash of result_key().
std::string run_name(const RunRequest& request);

/// "e0.5 d0.3", "edge 2.2 mm", "50000 vertices".
std::string sizing_text(const SizingRequest& sizing);

/// Whether a run is meant by --only: a glob over "dataset/label", "dataset/method" or the run's name.
bool selected(const RunRequest& request, const std::string& glob);

}  // namespace isobench
