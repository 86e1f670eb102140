#include "isobench/experiments/plan/config.h"

#include <fmt/format.h>

#include <algorithm>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/experiments/plan/config_parts.h"
#include "isobench/foundation/names.h"
#include "isobench/methods/method.h"
#include "isobench/reports/published/published.h"

namespace isobench {

namespace {

Limits read_limits(const TomlValue& table) {
  table.allow_keys({"minutes", "memory_gb"}, "[limits]");
  Limits limits;
  if (const auto minutes = table.find("minutes")) limits.minutes = positive(*minutes, "minutes");
  if (const auto memory = table.find("memory_gb")) limits.memory_gb = positive(*memory, "memory_gb");
  return limits;
}

std::vector<std::string> read_datasets(const TomlValue& value) {
  std::vector<std::string> names;
  for (const TomlValue& element : nonempty_list(value, "dataset")) {
    const std::string name = element.as_string();
    dataset_checksum(name, element.place());  // throws for a name or a manifest that is not there
    if (std::find(names.begin(), names.end(), name) != names.end()) {
      throw UsageError(element.place(), "dataset '" + name + "' is listed twice");
    }
    names.push_back(name);
  }
  return names;
}

std::vector<std::uint64_t> read_seeds(const TomlValue& value) {
  std::vector<std::uint64_t> seeds;
  for (const TomlValue& element : nonempty_list(value, "seed")) {
    const std::int64_t seed = element.as_integer();
    if (seed < 0) throw UsageError(element.place(), fmt::format("seed is {}; it must be a whole number >= 0", seed));
    seeds.push_back(static_cast<std::uint64_t>(seed));
  }
  return seeds;
}

// Titles and labels stand in tables, pages and terminals.
void check_line(const TomlValue& value, const std::string& what, std::size_t longest) {
  const std::string text = value.as_string();
  if (text.size() > longest || printable(text) != text) {
    throw UsageError(value.place(), fmt::format("{} must be one printable line of up to {} bytes", what, longest));
  }
}

std::string missing(const Method& found, const ParameterSpec& spec) {
  return fmt::format("{} needs '{}', {}", found.name, spec.name, spec.description);
}

MethodEntry read_method(const TomlValue& table) {
  const TomlValue name = table.require("name");
  const Method& found = method(name.as_string(), name.place());
  std::vector<std::string> keys = {"name", "label"};
  for (const ParameterSpec& spec : found.parameters) keys.push_back(spec.name);
  table.allow_keys(keys, "[[method]] " + found.name);

  MethodEntry entry;
  entry.name = found.name;
  entry.label = found.name;
  entry.place = table.place();
  if (const auto label = table.find("label")) {
    entry.label = label->as_string();
    entry.place = label->place();
    if (entry.label.empty()) throw UsageError(label->place(), "label is empty; leave it out or give it a text");
    check_line(*label, "label", 100);
  }
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
    if (spec.required && !entry.parameters.contains(spec.name)) throw UsageError(table.place(), missing(found, spec));
  }
  return entry;
}

std::vector<MethodEntry> read_methods(const TomlValue& document) {
  std::vector<MethodEntry> entries;
  for (const TomlValue& table : nonempty_list(document.require("method"), "method")) {
    MethodEntry entry = read_method(table);
    for (const MethodEntry& other : entries) {
      if (other.label == entry.label) {
        throw UsageError(entry.place,
                         "label '" + entry.label + "' is used twice; give each entry of one method a label of its own");
      }
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

// Names that an override may give, with a mistake for those it may not.
std::vector<std::string> read_targets(const TomlValue& table, const std::string& key,
                                      const std::vector<std::string>& known) {
  std::vector<std::string> names;
  const std::optional<TomlValue> value = table.find(key);
  if (!value) return names;
  for (const TomlValue& element : nonempty_list(*value, key)) {
    names.push_back(element.as_string());
    if (std::find(known.begin(), known.end(), names.back()) == known.end()) {
      throw UsageError(element.place(), fmt::format("this experiment has no {} '{}'{}", key, names.back(),
                                                    suggestion(names.back(), known)));
    }
  }
  return names;
}

Override read_override(const TomlValue& table, const std::vector<std::string>& datasets,
                       const std::vector<std::string>& methods) {
  table.allow_keys({"dataset", "method", "sampling", "limits", "artefacts"}, "[[override]]");
  Override change;
  change.datasets = read_targets(table, "dataset", datasets);
  change.methods = read_targets(table, "method", methods);
  if (change.datasets.empty() && change.methods.empty()) {
    throw UsageError(table.place(), "an [[override]] names neither dataset nor method; say which runs it changes");
  }
  if (const auto sampling = table.find("sampling")) change.sampling = read_sampling(*sampling);
  if (const auto limits = table.find("limits")) change.limits = read_limits(*limits);
  if (const auto artefacts = table.find("artefacts")) change.artefacts = artefacts->as_bool();
  return change;
}

void keep_methods(Config& config, const TomlValue& value) {
  std::vector<std::string> labels;
  for (const MethodEntry& entry : config.methods) labels.push_back(entry.label);
  std::vector<std::string> kept;
  for (const TomlValue& element : nonempty_list(value, "method")) {
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
    throw UsageError(value.place(), "[quick] leaves out '" + config.match->to + "', which the others are matched to");
  }
}

int read_repeats(const TomlValue& value) {
  const std::int64_t repeats = value.as_integer();
  if (repeats < 1 || repeats > 1000) {
    throw UsageError(value.place(), fmt::format("repeats is {}; it must be a whole number 1..1000", repeats));
  }
  return static_cast<int>(repeats);
}

Aside read_aside(const TomlValue& table) {
  table.allow_keys({"dataset", "seed", "sampling", "method"}, "[[also]]");
  Aside aside;
  aside.datasets = read_datasets(table.require("dataset"));
  if (const auto seeds = table.find("seed")) aside.seeds = read_seeds(*seeds);
  aside.sampling = read_sampling(table.require("sampling"));
  check_kind(aside.sampling);
  aside.methods = read_methods(table);
  return aside;
}

void apply_quick(Config& config, const TomlValue& quick) {
  if (const auto datasets = quick.find("dataset")) config.datasets = read_datasets(*datasets);
  if (const auto seeds = quick.find("seed")) {
    config.seeds = read_seeds(*seeds);
    for (Aside& aside : config.also) aside.seeds = config.seeds;
  }
  if (const auto repeats = quick.find("repeats")) config.repeats = read_repeats(*repeats);
  if (const auto methods = quick.find("method")) keep_methods(config, *methods);
  if (const auto sampling = quick.find("sampling")) {
    config.sampling = merged(config.sampling, read_sampling(*sampling));
    check_kind(config.sampling);
  }
}

std::vector<int> read_reference_k(const TomlValue& table) {
  table.allow_keys({"k"}, "[reference]");
  std::vector<int> refinements;
  for (const TomlValue& value : nonempty_list(table.require("k"), "k"))
    refinements.push_back(reference_refinement(value));
  return refinements;
}

// The entry is named by its label, or by its method where there is but one of it.
Match read_match(const TomlValue& document, const std::vector<MethodEntry>& methods) {
  const TomlValue kind = document.require("match");
  if (kind.as_string() != "vertices") {
    throw UsageError(kind.place(), "match is '" + kind.as_string() + "'; what can be matched is \"vertices\"");
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
  const MethodEntry& entry = *meant.front();
  if (entry.label != to.as_string() && meant.size() > 1) {
    throw UsageError(to.place(), fmt::format("{} entries are of the method '{}'; give the label of the one to match to",
                                             meant.size(), to.as_string()));
  }
  for (const auto& [name, values] : entry.parameters) {
    if (values.size() > 1) {
      throw UsageError(to.place(), fmt::format("'{}' has {} values of {}, and runs can be matched to one of them only; "
                                               "give that one a [[method]] entry of its own",
                                               entry.label, values.size(), name));
    }
  }
  return {entry.label, to.place()};
}

std::filesystem::path read_published_path(const TomlValue& table, const std::filesystem::path& folder) {
  table.allow_keys({"source"}, "[published]");
  const TomlValue source = table.require("source");
  std::filesystem::path path = folder / source.as_string();
  if (!std::filesystem::is_regular_file(path)) {
    throw UsageError(source.place(), "no file '" + path.string() + "' of published figures (sought beside the config)");
  }
  read_published(path);  // a mistake in it shows now, and nothing else is ever copied into a results folder
  return path;
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
    // Found here rather than in the middle of planning: the combination must still be one kind of sizing.
    check_kind(merged(config.sampling, config.overrides.back().sampling));
  }
}

// [quick] may leave out what overrides and variations are about. The stored config must be one that can be read.
void forget_what_is_left_out(Config& config) {
  std::erase_if(config.overrides, [&config](Override& change) {
    const bool all_datasets = change.datasets.empty();
    const bool all_methods = change.methods.empty();
    std::erase_if(change.datasets, [&config](const std::string& name) {
      return std::find(config.datasets.begin(), config.datasets.end(), name) == config.datasets.end();
    });
    std::erase_if(change.methods, [&config](const std::string& name) {
      return std::none_of(config.methods.begin(), config.methods.end(),
                          [&name](const MethodEntry& entry) { return entry.name == name || entry.label == name; });
    });
    return (!all_datasets && change.datasets.empty()) || (!all_methods && change.methods.empty());
  });
  std::erase_if(config.variations, [&config](const Variation& variation) {
    return std::none_of(config.methods.begin(), config.methods.end(),
                        [&variation](const MethodEntry& entry) { return variation.changes(entry); });
  });
}

}  // namespace

Sampling merged(const Sampling& base, const Sampling& change) {
  Sampling result = base;
  const bool adaptive = !change.epsilon.empty() || !change.delta.empty();
  const bool uniform = !change.edge_length.empty() || !change.vertices.empty();
  if (adaptive) result.edge_length = result.vertices = {};
  if (uniform) result.epsilon = result.delta = result.edge_length = result.vertices = {};
  if (!change.epsilon.empty()) result.epsilon = change.epsilon;
  if (!change.delta.empty()) result.delta = change.delta;
  if (!change.edge_length.empty()) result.edge_length = change.edge_length;
  if (!change.vertices.empty()) result.vertices = change.vertices;
  if (!change.floor.empty()) result.floor = change.floor;
  if (adaptive && uniform) {  // keep the contradiction for check_kind to report
    result.epsilon = change.epsilon;
    result.delta = change.delta;
  }
  if (adaptive || uniform || !change.floor.empty()) result.place = change.place;
  return result;
}

void check_kind(const Sampling& sampling) {
  const bool adaptive = !sampling.epsilon.empty() || !sampling.delta.empty();
  const int kinds = (adaptive ? 1 : 0) + (sampling.edge_length.empty() ? 0 : 1) + (sampling.vertices.empty() ? 0 : 1);
  const char* rule = "give exactly one of: epsilon and delta, edge_length, vertices";
  if (kinds == 0) throw UsageError(sampling.place, std::string("the sampling says no size; ") + rule);
  if (kinds > 1) throw UsageError(sampling.place, std::string("the sampling says several sizes; ") + rule);
  if (adaptive && sampling.delta.empty()) throw UsageError(sampling.place, "epsilon is given without delta");
  if (adaptive && sampling.epsilon.empty()) throw UsageError(sampling.place, "delta is given without epsilon");
}

Config read_config(const std::filesystem::path& path, Size size) {
  const TomlValue document = TomlValue::parse_file(path);
  document.allow_keys({"title", "dataset", "seed", "repeats", "timing", "artefacts", "match", "match_to", "sampling",
                       "override", "vary", "method", "also", "limits", "reference", "published", "quick"},
                      "an experiment");
  Config config;
  config.name = path.stem().string();
  if (!is_plain_name(config.name)) {
    throw UsageError(Place{path.string()},
                     "its name becomes that of the results folder; rename it to up to 100 plain characters");
  }
  config.title = config.name;
  if (const auto title = document.find("title")) {
    check_line(*title, "title", 1000);
    config.title = title->as_string();
  }
  config.datasets = read_datasets(document.require("dataset"));
  if (const auto seeds = document.find("seed")) config.seeds = read_seeds(*seeds);
  if (const auto repeats = document.find("repeats")) config.repeats = read_repeats(*repeats);
  config.timing = config.repeats > 1;
  if (const auto timing = document.find("timing")) config.timing = timing->as_bool();
  if (const auto artefacts = document.find("artefacts")) config.artefacts = artefacts->as_bool();
  config.sampling = read_sampling(document.require("sampling"));
  check_kind(config.sampling);
  config.methods = read_methods(document);
  if (document.find("match") || document.find("match_to")) config.match = read_match(document, config.methods);
  if (const auto also = document.find("also")) {
    for (const TomlValue& table : also->as_list()) config.also.push_back(read_aside(table));
  }
  if (const auto limits = document.find("limits")) config.limits = read_limits(*limits);
  if (const auto reference = document.find("reference")) config.reference_k = read_reference_k(*reference);
  if (const auto published = document.find("published")) {
    config.published = read_published_path(*published, path.parent_path());
  }
  // [quick] is checked whether it is used or not: a mistake in it is a mistake in the file.
  Config quick = config;
  std::vector<std::string> datasets = config.datasets;
  const std::optional<TomlValue> table = document.find("quick");
  if (table) {
    table->allow_keys({"dataset", "seed", "repeats", "sampling", "method"}, "[quick]");
    apply_quick(quick, *table);
    if (!document.find("timing")) quick.timing = quick.repeats > 1;
    datasets.insert(datasets.end(), quick.datasets.begin(), quick.datasets.end());
  }
  read_overrides(config, document, datasets);
  config.variations = read_variations(document, config);
  if (size == Size::full) return config;
  if (!table) throw UsageError(Place{path.string()}, "--quick needs a [quick] table, and this config has none");
  quick.name += "-quick";
  quick.overrides = config.overrides;
  quick.variations = config.variations;
  forget_what_is_left_out(quick);
  return quick;
}

}  // namespace isobench
