#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/experiments/command_line/verbs.h"
#include "isobench/experiments/terminal/terminal.h"
#include "isobench/foundation/toml.h"
#include "isobench/methods/method.h"
#include "isobench/metrics/metric.h"
#include "isobench/reports/csv/results_csv.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

// Every topic gives rows of cells: the first cell is a name, the last one a description.
using Rows = std::vector<std::vector<std::string>>;

Rows dataset_rows() {
  Rows rows;
  for (const DatasetInfo& dataset : list_datasets()) {
    const std::string licence = dataset.licence.empty() ? "" : "; licence: " + dataset.licence;
    rows.push_back({dataset.members.empty() ? dataset.name : dataset.members,
                    fmt::format("{}; source: {}{}", dataset.title, dataset.source, licence)});
  }
  return rows;
}

std::string range(const ParameterSpec& spec) {
  if (std::holds_alternative<bool>(spec.default_value)) return "true or false";
  if (!std::holds_alternative<double>(spec.default_value)) {
    return spec.choices.empty() ? "text" : fmt::format("one of {}", fmt::join(spec.choices, ", "));
  }
  std::string text = spec.integer ? "whole number" : "number";
  if (std::isfinite(spec.min) && std::isfinite(spec.max))
    return fmt::format("{} from {} to {}", text, spec.min, spec.max);
  if (std::isfinite(spec.min)) text += fmt::format(", at least {}", spec.min);
  if (std::isfinite(spec.max)) text += fmt::format(", at most {}", spec.max);
  return text;
}

std::string parameter_description(const ParameterSpec& spec) {
  const std::string unit = spec.unit.empty() ? "" : " " + spec.unit;
  const std::string otherwise = spec.required ? "must be given" : "default: " + to_string(spec.default_value) + unit;
  return fmt::format("{} ({}; {})", spec.description, range(spec), otherwise);
}

std::string method_description(const Method& method) {
  const char* promise = "";
  if (!method.deterministic) promise = "; not deterministic";
  if (method.deterministic && method.deterministic_with != nullptr) promise = "; deterministic with some parameters";
  return fmt::format("{} (revision {}{})", method.summary, method.revision, promise);
}

Rows method_rows() {
  Rows rows;
  for (const Method& method : methods()) {
    rows.push_back({method.name, method_description(method)});
    for (const ParameterSpec& spec : method.parameters) rows.push_back({"  " + spec.name, parameter_description(spec)});
  }
  return rows;
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

Rows metric_rows() {
  Rows rows;
  for (std::size_t n = 0; n < declared_figures().size(); ++n) {
    const FigureDeclaration& figure = declared_figures()[n];
    const char* when = metric_of_figure(n).when == When::on_request ? " Runs have it with metrics_of_use = true." : "";
    rows.push_back({figure.name, figure.unit, full_definition(figure) + needs(metric_of_figure(n)) + when});
  }
  return rows;
}

Rows column_rows() {
  Rows rows;
  for (const CsvColumn& column : csv_columns()) rows.push_back({column.name, column.unit, column.definition});
  return rows;
}

Rows experiment_rows() {
  std::vector<fs::path> configs;
  const fs::path folder = ISOBENCH_EXPERIMENTS;
  if (fs::is_directory(folder)) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() == ".toml") configs.push_back(entry.path());
    }
  }
  std::sort(configs.begin(), configs.end());
  Rows rows;
  for (const fs::path& config : configs) {
    const auto title = TomlValue::parse_file(config).find("title");
    rows.push_back({fs::proximate(config).string(), title ? title->as_string() : ""});
  }
  return rows;
}

}  // namespace

int list_verb(const std::string& topic) {
  struct Topic {
    std::string name;
    Rows (*rows)();
  };
  static const std::vector<Topic> topics = {{"datasets", dataset_rows},
                                            {"methods", method_rows},
                                            {"metrics", metric_rows},
                                            {"columns", column_rows},
                                            {"experiments", experiment_rows}};
  std::vector<std::string> names;
  bool found = false;
  for (const Topic& each : topics) {
    names.push_back(each.name);
    if (!topic.empty() && topic != each.name) continue;
    if (topic.empty()) fmt::print("{}{}:\n", found ? "\n" : "", each.name);
    fmt::print("{}", aligned_rows(each.rows(), output_width()));
    found = true;
  }
  if (!found) throw UsageError("nothing to list under '" + topic + "'" + suggestion(topic, names));
  return 0;
}

}  // namespace isobench
