// The runs that an experiment consists of.
#pragma once

#include <string>
#include <vector>

#include "isobench/experiments/plan/config.h"
#include "isobench/reports/record/record.h"

namespace isobench {

/// All runs of a config, ordered by dataset first. The base has a run for each combination of dataset, method entry,
/// values of its parameters, sampling, seed and repeat; each value of each [[vary]] adds the base again
/// with that change. No run comes twice. Needs no data: checksums are those that the catalogue declares. Throws
/// UsageError where two method entries ask for the same run.
std::vector<RunRequest> make_plan(const Config& config);

/// Everything that determines the result of a run, as text: dataset and its checksum, method and its revision,
/// parameters, sizing, match, seed, repeat, and the revision of the metrics. Limits, label and number of
/// threads do not determine it.
std::string result_key(const RunRequest& request);

/// The name of a run and of its folder, "skull-particles-e0.5-d0.3-s1-1f2a9c3e". It ends with a hash of result_key().
std::string run_name(const RunRequest& request);

/// "e0.5 d0.3", "edge 2.2 mm", "50000 vertices".
std::string sizing_text(const SizingRequest& sizing);

/// Whether the glob of --only matches "dataset/label", "dataset/method" or the name of the run.
bool selected(const RunRequest& request, const std::string& glob);

}  // namespace isobench
