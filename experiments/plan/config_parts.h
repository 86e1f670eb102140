// What the readers of a config's tables share.
#pragma once

#include <string>
#include <vector>

#include "isobench/experiments/plan/config.h"
#include "isobench/foundation/toml.h"

namespace isobench {

/// The elements of a list, or a value as the only one. Throws UsageError for an empty list.
std::vector<TomlValue> nonempty_list(const TomlValue& value, const std::string& what);
/// Throws UsageError unless finite and > 0.
double positive(const TomlValue& value, const std::string& what);
/// [reference] k: a whole number 1..8.
int reference_refinement(const TomlValue& value);
ParameterValue parameter_value(const TomlValue& value);

const std::vector<std::string>& sampling_keys();
/// The values of a sampling by key, one of sampling_keys().
std::vector<double>& sampling_values(Sampling& sampling, const std::string& key);
Sampling read_sampling(const TomlValue& table);

/// The [[vary]] blocks of a document whose other tables are read already.
std::vector<Variation> read_variations(const TomlValue& document, const Config& config);

}  // namespace isobench
