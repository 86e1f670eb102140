#include "isobench/experiments/plan/config_parts.h"

#include <fmt/format.h>

#include <cmath>

namespace isobench {

std::vector<TomlValue> nonempty_list(const TomlValue& value, const std::string& what) {
  std::vector<TomlValue> list = value.as_list();
  if (list.empty()) throw UsageError(value.place(), what + " is an empty list; give at least one value");
  return list;
}

double positive(const TomlValue& value, const std::string& what) {
  const double number = value.as_number();
  if (!std::isfinite(number) || number <= 0.0) {
    throw UsageError(value.place(), fmt::format("{} is {}; it must be a finite number > 0", what, number));
  }
  return number;
}

int reference_refinement(const TomlValue& value) {
  const std::int64_t k = value.as_integer();
  if (k < 1 || k > 8) {
    throw UsageError(value.place(), fmt::format("k is {}; the refinement of the reference is a whole number 1..8", k));
  }
  return static_cast<int>(k);
}

ParameterValue parameter_value(const TomlValue& value) {
  if (value.is_bool()) return value.as_bool();
  if (value.is_number()) return value.as_number();
  return value.as_string();
}

const std::vector<std::string>& sampling_keys() {
  static const std::vector<std::string> keys = {"epsilon", "delta", "floor", "edge_length", "vertices"};
  return keys;
}

std::vector<double>& sampling_values(Sampling& sampling, const std::string& key) {
  if (key == "epsilon") return sampling.epsilon;
  if (key == "delta") return sampling.delta;
  if (key == "floor") return sampling.floor;
  if (key == "edge_length") return sampling.edge_length;
  return sampling.vertices;
}

Sampling read_sampling(const TomlValue& table) {
  table.allow_keys(sampling_keys(), "[sampling]");
  Sampling sampling;
  for (const std::string& key : sampling_keys()) {
    const std::optional<TomlValue> value = table.find(key);
    if (!value) continue;
    for (const TomlValue& element : nonempty_list(*value, key)) {
      sampling_values(sampling, key).push_back(positive(element, key));
    }
  }
  sampling.place = table.place();
  return sampling;
}

}  // namespace isobench
