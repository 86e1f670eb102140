#include <fmt/format.h>

#include <algorithm>

#include "isobench/experiments/plan/config_readers.h"

namespace isobench {

namespace {

// The methods that an override is about, each one of `known`.
std::vector<std::string> read_method_targets(const TomlValue& list, const std::vector<std::string>& known) {
  std::vector<std::string> names;
  for (const TomlValue& element : nonempty_list(list, "method")) {
    names.push_back(element.as_string());
    if (std::find(known.begin(), known.end(), names.back()) == known.end()) {
      throw UsageError(element.place(), fmt::format("this experiment has no method '{}'{}", names.back(),
                                                    suggestion(names.back(), known)));
    }
  }
  return names;
}

Override read_override(const TomlValue& table, const std::vector<std::string>& datasets,
                       const std::vector<std::string>& methods) {
  table.allow_keys({"dataset", "method", "sampling", "limits", "artefacts"}, "[[override]]");
  Override change;
  if (const auto list = table.find("dataset")) change.datasets = read_own_datasets(*list, datasets);
  if (const auto list = table.find("method")) change.methods = read_method_targets(*list, methods);
  if (change.datasets.empty() && change.methods.empty()) {
    throw UsageError(table.place(), "an [[override]] needs dataset or method, to select the runs that it changes");
  }
  if (const auto sampling = table.find("sampling")) change.sampling = read_sampling(*sampling);
  if (const auto limits = table.find("limits")) change.limits = read_limits(*limits);
  if (const auto artefacts = table.find("artefacts")) change.artefacts = artefacts->as_bool();
  return change;
}

}  // namespace

Limits read_limits(const TomlValue& table) {
  table.allow_keys({"minutes", "memory_gb"}, "[limits]");
  Limits limits;
  if (const auto minutes = table.find("minutes")) limits.minutes = positive(*minutes, "minutes");
  if (const auto memory = table.find("memory_gb")) limits.memory_gb = positive(*memory, "memory_gb");
  return limits;
}

void read_overrides(Config& config, const TomlValue& document, const std::vector<std::string>& datasets) {
  const std::optional<TomlValue> overrides = document.find("override");
  if (!overrides) return;
  std::vector<std::string> methods;
  for (const MethodEntry& entry : config.methods) {
    methods.push_back(entry.name);
    if (entry.label != entry.name) methods.push_back(entry.label);
  }
  for (const TomlValue& table : overrides->as_list()) {
    config.overrides.push_back(read_override(table, datasets, methods));
    // With the change, too, there must be exactly one kind of sizing.
    check_kind(merged(config.sampling, config.overrides.back().sampling));
  }
}

namespace {

// Keeps the datasets that the experiment has. Returns false if a list that named some has none left: an empty list
// would mean all.
bool keep_known_datasets(const Config& config, std::vector<std::string>& datasets) {
  if (datasets.empty()) return true;
  std::erase_if(datasets, [&config](const std::string& name) {
    return std::find(config.datasets.begin(), config.datasets.end(), name) == config.datasets.end();
  });
  return !datasets.empty();
}

}  // namespace

void remove_unused_changes(Config& config) {
  std::erase_if(config.methods, [&config](MethodEntry& entry) { return !keep_known_datasets(config, entry.datasets); });
  std::erase_if(config.overrides, [&config](Override& change) {
    const bool all_methods = change.methods.empty();
    const bool has_datasets = keep_known_datasets(config, change.datasets);
    std::erase_if(change.methods, [&config](const std::string& name) {
      return std::none_of(config.methods.begin(), config.methods.end(),
                          [&name](const MethodEntry& entry) { return entry.name == name || entry.label == name; });
    });
    return !has_datasets || (!all_methods && change.methods.empty());
  });
  std::erase_if(config.variations, [&config](const Variation& variation) {
    return std::none_of(config.methods.begin(), config.methods.end(),
                        [&variation](const MethodEntry& entry) { return variation.changes(entry); });
  });
}

}  // namespace isobench
