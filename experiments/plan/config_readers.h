// Readers of the tables of a config, and of the values in them. All throw UsageError at the value's place.
#pragma once

#include <string>
#include <vector>

#include "isobench/experiments/plan/config.h"
#include "isobench/foundation/toml.h"

namespace isobench {

// --- values (config_values.cpp); `what` names a value in messages

/// The elements of a list that is not empty. A single value counts as a list of one.
std::vector<TomlValue> nonempty_list(const TomlValue& value, const std::string& what);
/// A finite number > 0.
double positive(const TomlValue& value, const std::string& what);
/// A whole number from `least` to `most`.
int whole_number(const TomlValue& value, const std::string& what, int least, int most);
/// A boolean, a number or a text.
ParameterValue parameter_value(const TomlValue& value);
/// A text of one printable line, as titles and labels are: they stand in tables, on pages and on terminals.
std::string printable_line(const TomlValue& value, const std::string& what, std::size_t longest);

// --- dataset (config_datasets.cpp)

/// The datasets that a list names, each once, all of them known. A glob stands for the names that it matches; what a
/// name or a glob before it has given already is not repeated. A name that is listed twice is an error.
std::vector<std::string> read_datasets(const TomlValue& list);
/// The same, of an experiment's own datasets, for a table that is about some of them.
std::vector<std::string> read_own_datasets(const TomlValue& list, const std::vector<std::string>& datasets);

// --- [sampling] (config_sampling.cpp)

const std::vector<std::string>& sampling_keys();
/// The values of a sampling by their key, one of sampling_keys().
std::vector<double>& sampling_values(Sampling& sampling, const std::string& key);
/// Does not check that it asks for exactly one kind of sizing: an override may give a part of one.
Sampling read_sampling(const TomlValue& table);

// --- [[method]], match and match_to (config_methods.cpp)

/// The [[method]] tables of a document or of an [[also]], which has these datasets.
std::vector<MethodEntry> read_methods(const TomlValue& table, const std::vector<std::string>& datasets);
/// match and match_to of a document that has one of them. The entry to match to is named by its label, or by its method
/// where that has only one entry.
Match read_match(const TomlValue& document, const std::vector<MethodEntry>& methods);
/// Keeps the methods that [quick] names by their labels.
void keep_methods(Config& config, const TomlValue& names);

// --- [limits] and [[override]] (config_overrides.cpp)

Limits read_limits(const TomlValue& table);
/// Adds the [[override]] tables of a document to a config whose methods and sampling are read. `datasets` are the names
/// that an override may change.
void read_overrides(Config& config, const TomlValue& document, const std::vector<std::string>& datasets);
/// Removes what is about datasets and methods that [quick] left out: overrides, variations, and methods that run on
/// none of its datasets. read_config() would refuse them in the config that a results folder keeps.
void remove_unused_changes(Config& config);

// --- [[vary]] (config_variations.cpp)

/// The [[vary]] tables of a document whose other tables have been read into `config`.
std::vector<Variation> read_variations(const TomlValue& document, const Config& config);

}  // namespace isobench
