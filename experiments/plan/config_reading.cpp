#include <fmt/format.h>

#include <algorithm>

#include "isobench/experiments/plan/config.h"
#include "isobench/experiments/plan/config_readers.h"
#include "isobench/foundation/names.h"
#include "isobench/reports/published/published.h"

namespace isobench {

namespace {

std::vector<std::uint64_t> read_seeds(const TomlValue& value) {
  std::vector<std::uint64_t> seeds;
  for (const TomlValue& element : nonempty_list(value, "seed")) {
    const std::int64_t seed = element.as_integer();
    if (seed < 0) throw UsageError(element.place(), fmt::format("seed is {}; expected a whole number >= 0", seed));
    seeds.push_back(static_cast<std::uint64_t>(seed));
  }
  return seeds;
}

int read_repeats(const TomlValue& value) { return whole_number(value, "repeats", 1, 1000); }

Aside read_aside(const TomlValue& table) {
  table.allow_keys({"dataset", "seed", "sampling", "method"}, "[[also]]");
  Aside aside;
  aside.datasets = read_datasets(table.require("dataset"));
  if (const auto seeds = table.find("seed")) aside.seeds = read_seeds(*seeds);
  aside.sampling = read_sampling(table.require("sampling"));
  check_kind(aside.sampling);
  aside.methods = read_methods(table, aside.datasets);
  return aside;
}

/// The datasets that a table of the document may be about: those of the experiment, and those of its [quick].
std::vector<std::string> all_datasets(const TomlValue& document, std::vector<std::string> datasets) {
  const auto quick = document.find("quick");
  const auto list = quick ? quick->find("dataset") : std::nullopt;
  if (!list) return datasets;
  for (const std::string& name : read_datasets(*list)) {
    if (std::find(datasets.begin(), datasets.end(), name) == datasets.end()) datasets.push_back(name);
  }
  return datasets;
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

/// Removes what is about other datasets than the config's, and refuses what is then without a method.
void keep_what_runs(Config& config, const Place& place) {
  remove_unused_changes(config);
  if (config.methods.empty()) {
    throw UsageError(place, "no method runs on any of these datasets; add a dataset that a [[method]] names");
  }
  if (!config.match) return;
  const auto is_meant = [&config](const MethodEntry& entry) { return entry.label == config.match->to; };
  if (std::none_of(config.methods.begin(), config.methods.end(), is_meant)) {
    throw UsageError(place, fmt::format("'{}' runs on none of these datasets, but match_to names it; add one of its "
                                        "datasets",
                                        config.match->to));
  }
}

/// Older versions counted the topology of F = c on a lattice, and [reference] said how fine. It is in each of their
/// results folders, and is ignored there.
void refuse_reference(const TomlValue& document) {
  const auto reference = document.find("reference");
  if (!reference) return;
  throw UsageError(reference->place(),
                   "the topology of the surface is now proven, not counted on a lattice; remove the table [reference]");
}

std::filesystem::path read_published_path(const TomlValue& table, const std::filesystem::path& folder) {
  table.allow_keys({"source"}, "[published]");
  const TomlValue source = table.require("source");
  std::filesystem::path path = folder / source.as_string();
  if (!std::filesystem::is_regular_file(path)) {
    throw UsageError(source.place(), "there is no file '" + path.string() +
                                         "' of published figures; its path is relative to the config's folder");
  }
  read_published(path);  // throws for any other file, which would otherwise be copied into the results folder
  return path;
}

}  // namespace

Config read_config(const std::filesystem::path& path, ConfigVariant variant) {
  const TomlValue document = TomlValue::parse_file(path);
  document.allow_keys(
      {"title", "dataset", "seed", "repeats", "timing", "artefacts", "metrics_of_use", "min_component", "match",
       "match_to", "sampling", "override", "vary", "method", "also", "limits", "reference", "published", "quick"},
      "an experiment");
  if (variant != ConfigVariant::stored) refuse_reference(document);
  Config config;
  config.name = path.stem().string();
  if (!is_plain_name(config.name)) {
    throw UsageError(
        Place{path.string()},
        "the results folder gets the name of this file, but it cannot be the name of a folder; rename it: at most 100 "
        "printable characters, without '/', and the first neither '.' nor '-'");
  }
  config.title = config.name;
  if (const auto title = document.find("title")) config.title = printable_line(*title, "title", 1000);
  config.datasets = read_datasets(document.require("dataset"));
  if (const auto seeds = document.find("seed")) config.seeds = read_seeds(*seeds);
  if (const auto repeats = document.find("repeats")) config.repeats = read_repeats(*repeats);
  config.timing = config.repeats > 1;
  if (const auto timing = document.find("timing")) config.timing = timing->as_bool();
  if (const auto artefacts = document.find("artefacts")) config.artefacts = artefacts->as_bool();
  if (const auto use = document.find("metrics_of_use")) config.metrics_of_use = use->as_bool();
  if (const auto least = document.find("min_component")) config.min_component = positive(*least, "min_component");
  config.sampling = read_sampling(document.require("sampling"));
  check_kind(config.sampling);
  const std::vector<std::string> datasets = all_datasets(document, config.datasets);
  config.methods = read_methods(document, datasets);
  if (document.find("match") || document.find("match_to")) config.match = read_match(document, config.methods);
  if (const auto also = document.find("also")) {
    for (const TomlValue& table : also->as_list()) config.also.push_back(read_aside(table));
  }
  if (const auto limits = document.find("limits")) config.limits = read_limits(*limits);
  if (const auto published = document.find("published")) {
    config.published = read_published_path(*published, path.parent_path());
  }
  // [quick] is read even where it is not asked for, so that a mistake in it is found.
  Config quick = config;
  const std::optional<TomlValue> table = document.find("quick");
  if (table) {
    table->allow_keys({"dataset", "seed", "repeats", "sampling", "method"}, "[quick]");
    apply_quick(quick, *table);
    if (!document.find("timing")) quick.timing = quick.repeats > 1;
  }
  read_overrides(config, document, datasets);
  config.variations = read_variations(document, config);
  if (variant != ConfigVariant::quick) {
    keep_what_runs(config, document.require("dataset").place());
    return config;
  }
  if (!table)
    throw UsageError(Place{path.string()},
                     "--quick needs a [quick] table, but this config has none; add one, or leave out --quick");
  quick.name += "-quick";
  quick.overrides = config.overrides;
  quick.variations = config.variations;
  keep_what_runs(quick, table->place());
  return quick;
}

}  // namespace isobench
