#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/experiments/command_line/verbs.h"
#include "isobench/foundation/toml.h"
#include "isobench/methods/method.h"
#include "isobench/metrics/metric.h"
#include "isobench/reports/csv/results_csv.h"
#include "isobench/reports/record/environment.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

void list_all_datasets() {
  for (const DatasetInfo& dataset : list_datasets()) {
    fmt::print("{:16} {}\n", dataset.name, dataset.title);
    const std::string licence = dataset.licence.empty() ? "" : "; licence: " + dataset.licence;
    fmt::print("{:16} source: {}{}\n", "", dataset.source, licence);
  }
}

std::string range(const ParameterSpec& spec) {
  std::string text;
  if (std::holds_alternative<double>(spec.default_value)) {
    text = spec.integer ? "whole number" : "number";
    if (std::isfinite(spec.min)) text += fmt::format(", at least {}", spec.min);
    if (std::isfinite(spec.max)) text += fmt::format(", at most {}", spec.max);
  } else if (std::holds_alternative<bool>(spec.default_value)) {
    text = "true or false";
  } else {
    text = spec.choices.empty() ? "text" : fmt::format("one of {}", fmt::join(spec.choices, ", "));
  }
  return text;
}

void list_all_methods() {
  for (const Method& method : methods()) {
    const char* promise = !method.deterministic                  ? "; not deterministic"
                          : method.deterministic_with != nullptr ? "; deterministic with some parameters"
                                                                 : "";
    fmt::print("{:16} {} (revision {}{})\n", method.name, method.summary, method.revision, promise);
    for (const ParameterSpec& spec : method.parameters) {
      const std::string unit = spec.unit.empty() ? "" : " " + spec.unit;
      const std::string otherwise = spec.required ? "must be given" : "default " + to_string(spec.default_value) + unit;
      fmt::print("  {:14} {}: {}; {}\n", spec.name, spec.description, range(spec), otherwise);
    }
  }
}

std::string needs(const Metric& metric) {
  switch (metric.needs) {
    case Needs::mesh:
      return "";
    case Needs::surface:
      return " Needs the surface.";
    case Needs::sizing:
      return " Needs the surface and a sizing.";
  }
  return "";
}

void list_all_metrics() {
  for (std::size_t n = 0; n < declared_figures().size(); ++n) {
    const FigureDeclaration& figure = declared_figures()[n];
    fmt::print("{:28} {:8} {}{}\n", figure.name, figure.unit, full_definition(figure), needs(metric_of_figure(n)));
  }
}

void list_all_columns() {
  for (const CsvColumn& column : csv_columns()) {
    fmt::print("{:28} {:8} {}\n", column.name, column.unit, column.definition);
  }
}

void list_all_experiments() {
  std::vector<fs::path> configs;
  const fs::path folder = ISOBENCH_EXPERIMENTS;
  if (fs::is_directory(folder)) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() == ".toml") configs.push_back(entry.path());
    }
  }
  std::sort(configs.begin(), configs.end());
  for (const fs::path& config : configs) {
    const auto title = TomlValue::parse_file(config).find("title");
    fmt::print("{:32} {}\n", fs::proximate(config).string(), title ? title->as_string() : "");
  }
}

}  // namespace

int list_verb(const std::string& topic) {
  struct Topic {
    std::string name;
    void (*print)();
  };
  static const std::vector<Topic> topics = {{"datasets", list_all_datasets},
                                            {"methods", list_all_methods},
                                            {"metrics", list_all_metrics},
                                            {"columns", list_all_columns},
                                            {"experiments", list_all_experiments}};
  std::vector<std::string> names;
  bool found = false;
  for (const Topic& each : topics) {
    names.push_back(each.name);
    if (!topic.empty() && topic != each.name) continue;
    if (topic.empty()) fmt::print("{}{}:\n", found ? "\n" : "", each.name);
    each.print();
    found = true;
  }
  if (!found) throw UsageError("nothing to list under '" + topic + "'" + suggestion(topic, names));
  return 0;
}

int fetch_verb(std::vector<std::string> datasets, const CommonArguments& common) {
  if (datasets.empty()) datasets = dataset_names();
  Console console(common.verbosity);
  ConsoleSink sink(console);
  Monitor monitor(&sink);
  for (const std::string& name : datasets) {
    const std::vector<fs::path> files = fetch_dataset(name, monitor);
    console.clear();
    for (const fs::path& file : files) fmt::print("{}\n", file.string());
  }
  return 0;
}

int version_verb() {
  const Environment here = environment();
  fmt::print("isobench {} (commit {}{})\n{}, {}\n", here.version, here.commit, here.dirty ? ", changed" : "",
             here.compiler, here.build_type);
  for (const auto& [name, version] : *here.libraries) fmt::print("{} {}\n", name, version);
  return 0;
}

}  // namespace isobench
