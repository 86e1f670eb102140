#include <fmt/format.h>

#include <algorithm>

#include "isobench/experiments/plan/config_readers.h"
#include "isobench/methods/method.h"

namespace isobench {

namespace {

MethodEntry read_method(const TomlValue& table, const std::vector<std::string>& datasets) {
  const TomlValue name = table.require("name");
  const Method& found = method(name.as_string(), name.place());
  std::vector<std::string> keys = {"name", "label", "dataset"};
  for (const ParameterSpec& spec : found.parameters) keys.push_back(spec.name);
  table.allow_keys(keys, "[[method]] " + found.name);

  MethodEntry entry;
  entry.name = found.name;
  entry.label = found.name;
  entry.place = table.place();
  if (const auto label = table.find("label")) {
    entry.label = printable_line(*label, "label", 100);
    entry.place = label->place();
    if (entry.label.empty()) throw UsageError(label->place(), "label is empty; remove it, or give it a text");
  }
  if (const auto list = table.find("dataset")) entry.datasets = read_own_datasets(*list, datasets);
  for (const ParameterSpec& spec : found.parameters) {
    const std::optional<TomlValue> value = table.find(spec.name);
    if (!value) continue;
    for (const TomlValue& element : nonempty_list(*value, spec.name)) {
      Parameters checked(found.parameters);
      checked.set(found.parameters, spec.name, parameter_value(element), element.place());
      entry.parameters[spec.name].push_back(checked.all().at(spec.name));
    }
  }
  for (const ParameterSpec& spec : found.parameters) {
    if (!spec.required || entry.parameters.contains(spec.name)) continue;
    throw UsageError(table.place(), fmt::format("{} needs '{}', {}", found.name, spec.name, spec.description));
  }
  return entry;
}

}  // namespace

bool MethodEntry::runs_on(const std::string& dataset) const {
  return datasets.empty() || std::find(datasets.begin(), datasets.end(), dataset) != datasets.end();
}

std::vector<MethodEntry> read_methods(const TomlValue& document, const std::vector<std::string>& datasets) {
  std::vector<MethodEntry> entries;
  for (const TomlValue& table : nonempty_list(document.require("method"), "method")) {
    MethodEntry entry = read_method(table, datasets);
    for (const MethodEntry& other : entries) {
      if (other.label == entry.label) {
        throw UsageError(entry.place,
                         "label '" + entry.label + "' is used twice; give each entry of a method a label of its own");
      }
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

Match read_match(const TomlValue& document, const std::vector<MethodEntry>& methods) {
  const TomlValue kind = document.require("match");
  if (kind.as_string() != "vertices") {
    throw UsageError(kind.place(), "match is '" + kind.as_string() + "'; expected \"vertices\"");
  }
  const TomlValue to = document.require("match_to");
  std::vector<std::string> known;
  std::vector<const MethodEntry*> meant;
  for (const MethodEntry& entry : methods) {
    known.insert(known.end(), {entry.label, entry.name});
    if (entry.label == to.as_string())
      meant.insert(meant.begin(), &entry);
    else if (entry.name == to.as_string())
      meant.push_back(&entry);
  }
  if (meant.empty()) {
    throw UsageError(to.place(),
                     "this experiment has no method '" + to.as_string() + "'" + suggestion(to.as_string(), known));
  }
  // An entry of that label comes first. A method's name is enough if it has only one entry.
  const MethodEntry& entry = *meant.front();
  if (entry.label != to.as_string() && meant.size() > 1) {
    throw UsageError(to.place(), fmt::format("{} entries are of the method '{}'; give the label of one of them",
                                             meant.size(), to.as_string()));
  }
  for (const auto& [name, values] : entry.parameters) {
    if (values.size() > 1) {
      throw UsageError(to.place(), fmt::format("'{}' has {} values of {}, but runs can be matched to one of them only; "
                                               "give that value a [[method]] entry of its own",
                                               entry.label, values.size(), name));
    }
  }
  return {entry.label, to.place()};
}

void keep_methods(Config& config, const TomlValue& names) {
  std::vector<std::string> labels;
  for (const MethodEntry& entry : config.methods) labels.push_back(entry.label);
  std::vector<std::string> kept;
  for (const TomlValue& element : nonempty_list(names, "method")) {
    kept.push_back(element.as_string());
    if (std::find(labels.begin(), labels.end(), kept.back()) == labels.end()) {
      throw UsageError(element.place(), "this experiment has no method labelled '" + kept.back() + "'" +
                                            suggestion(kept.back(), labels));
    }
  }
  std::erase_if(config.methods, [&kept](const MethodEntry& entry) {
    return std::find(kept.begin(), kept.end(), entry.label) == kept.end();
  });
  if (config.match && std::find(kept.begin(), kept.end(), config.match->to) == kept.end()) {
    throw UsageError(names.place(),
                     "[quick] leaves out '" + config.match->to + "', but match_to names it; add it to method");
  }
}

}  // namespace isobench
