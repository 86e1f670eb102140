#include "isobench/datasets/manifests/manifest_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

/// A number within the range of float, because F is made from floats.
double parse_finite(const TomlValue& value) {
  const double number = value.as_number();
  if (!(std::abs(number) <= std::numeric_limits<float>::max())) {
    throw UsageError(value.place(), "a finite number of at most 3.4e38 is expected");
  }
  return number;
}

int count_or(const TomlValue& table, const char* key, int otherwise, int least) {
  const auto found = table.find(key);
  return found ? parse_count(*found, least) : otherwise;
}

PrepareStep parse_gaussian(const TomlValue& table) {
  const TomlValue sigma = table.require("sigma");
  Gaussian step{parse_triple(sigma)};
  if (step.sigma.maxCoeff() > 1000.0) throw UsageError(sigma.place(), "sigma is at most 1000 voxels");
  return step;
}

PrepareStep parse_labels(const TomlValue& table) {
  SelectLabels step;
  for (const TomlValue& label : table.require("labels").as_list()) step.labels.push_back(label.as_integer());
  if (step.labels.empty()) throw UsageError(table.place(), "labels: at least one label is expected");
  return step;
}

PrepareStep parse_cut(const TomlValue& table) {
  const TomlValue from = table.require("from");
  if (from.as_array().size() != 3) throw UsageError(from.place(), "three numbers are expected, the first node to keep");
  return Cut{parse_counts(from, 0), parse_counts(table.require("size"), 1)};
}

PrepareStep parse_close_border(const TomlValue& table, const ManifestSurface& surface) {
  for (const char* key : {"to", "value", "layers"}) {
    if (const auto old = table.find(key)) {
      throw UsageError(old->place(), fmt::format("close-border adds layers outside the volume now, with a value of its "
                                                 "own; remove '{}'",
                                                 key));
    }
  }
  return CloseBorder{surface.isovalue, surface.inside == Inside::below};
}

/// A step's own keys, and the function that makes the step from them.
struct StepParser {
  std::vector<std::string> keys;
  std::function<PrepareStep(const TomlValue&, const ManifestSurface&)> parse;
};

const std::map<std::string, StepParser>& step_parsers() {
  static const std::map<std::string, StepParser> parsers = {
      {"threshold",
       {{"at"}, [](const TomlValue& t, const ManifestSurface&) { return Threshold{parse_finite(t.require("at"))}; }}},
      {"labels", {{"labels"}, [](const TomlValue& t, const ManifestSurface&) { return parse_labels(t); }}},
      {"largest-component", {{}, [](const TomlValue&, const ManifestSurface&) { return LargestComponent{}; }}},
      {"crop",
       {{"margin"}, [](const TomlValue& t, const ManifestSurface&) { return Crop{count_or(t, "margin", 0, 0)}; }}},
      {"pad",
       {{"voxels", "value"},
        [](const TomlValue& t, const ManifestSurface&) {
          const auto value = t.find("value");
          return Pad{parse_count(t.require("voxels"), 0), value ? parse_finite(*value) : 0.0};
        }}},
      {"resample",
       {{"spacing"},
        [](const TomlValue& t, const ManifestSurface&) { return Resample{parse_triple(t.require("spacing"))}; }}},
      {"signed-distance", {{}, [](const TomlValue&, const ManifestSurface&) { return SignedDistance{}; }}},
      {"cut", {{"from", "size"}, [](const TomlValue& t, const ManifestSurface&) { return parse_cut(t); }}},
      {"gaussian", {{"sigma"}, [](const TomlValue& t, const ManifestSurface&) { return parse_gaussian(t); }}},
      {"close-border", {{"to", "value", "layers"}, parse_close_border}},
      {"subsample",
       {{"factor"},
        [](const TomlValue& t, const ManifestSurface&) { return Subsample{parse_count(t.require("factor"), 1)}; }}},
  };
  return parsers;
}

PrepareStep parse_step(const TomlValue& table, const ManifestSurface& surface) {
  const TomlValue name_value = table.require("step");
  const std::string name = name_value.as_string();
  const auto found = step_parsers().find(name);
  if (found == step_parsers().end()) {
    std::vector<std::string> names;
    for (const auto& entry : step_parsers()) names.push_back(entry.first);
    throw UsageError(name_value.place(), fmt::format("unknown preparation step '{}'{}", name, suggestion(name, names)));
  }
  std::vector<std::string> keys = found->second.keys;
  keys.emplace_back("step");
  table.allow_keys(keys, "the step " + name);
  return found->second.parse(table, surface);
}

}  // namespace

std::vector<PrepareStep> parse_steps(const TomlValue& list, const ManifestSurface& surface) {
  std::vector<PrepareStep> steps;
  for (const TomlValue& table : list.as_array()) steps.push_back(parse_step(table, surface));
  return steps;
}

Eigen::Vector3d parse_triple(const TomlValue& value) {
  const std::vector<TomlValue> list = value.as_list();
  if (list.size() != 1 && list.size() != 3) throw UsageError(value.place(), "one number or three are expected");
  Eigen::Vector3d triple;
  for (int axis = 0; axis < 3; ++axis) {
    const TomlValue& entry = list[list.size() == 1 ? 0 : static_cast<std::size_t>(axis)];
    triple[axis] = parse_finite(entry);
    if (!(triple[axis] > 0.0)) throw UsageError(entry.place(), "a number > 0 is expected");
  }
  return triple;
}

int parse_count(const TomlValue& value, int least, int most) {
  const std::int64_t count = value.as_integer();
  if (count < least || count > most) {
    const std::string limit = count > most ? fmt::format("at most {}", most) : fmt::format("at least {}", least);
    throw UsageError(value.place(), fmt::format("an integer of {} is expected, found {}", limit, count));
  }
  return static_cast<int>(count);
}

std::array<int, 3> parse_counts(const TomlValue& value, int least, int most) {
  const std::vector<TomlValue> list = value.as_list();
  if (list.size() != 1 && list.size() != 3) throw UsageError(value.place(), "one number or three are expected");
  std::array<int, 3> counts{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    counts[axis] = parse_count(list[list.size() == 1 ? 0 : axis], least, most);
  return counts;
}

}  // namespace isobench
