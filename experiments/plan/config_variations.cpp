// [[vary]]: one value changed at a time.
#include <fmt/format.h>

#include <algorithm>

#include "isobench/experiments/plan/config_readers.h"
#include "isobench/methods/method.h"

namespace isobench {

namespace {

constexpr const char* rule =
    "a [[vary]] changes sampling.<key> or method.<label>.<parameter>, e.g. key = \"sampling.epsilon\"";

UsageError several_values(const std::string& who, const Variation& variation) {
  return {variation.place, fmt::format("{} gives several values of {}, but a [[vary]] starts from one; keep one of "
                                       "them, or remove the [[vary]] to get a grid",
                                       who, variation.name)};
}

void read_sampling_variation(const TomlValue& values, const Config& config, Variation& variation) {
  const std::vector<std::string>& keys = sampling_keys();
  if (std::find(keys.begin(), keys.end(), variation.name) == keys.end()) {
    throw UsageError(variation.place,
                     "unknown key '" + variation.name + "' in [sampling]" + suggestion(variation.name, keys));
  }
  Sampling base = config.sampling;
  if (sampling_values(base, variation.name).size() > 1) {
    throw several_values("[sampling]", variation);
  }
  for (const TomlValue& element : nonempty_list(values, "values")) {
    variation.values.emplace_back(positive(element, variation.name));
  }
  check_kind(merged(config.sampling, variation_sampling(variation, variation.values.front())));
}

void read_method_variation(const TomlValue& values, const Config& config, Variation& variation) {
  const std::size_t dot = variation.name.rfind('.');
  if (dot == std::string::npos) throw UsageError(variation.place, rule);
  variation.method = variation.name.substr(0, dot);
  variation.name.erase(0, dot + 1);
  std::vector<std::string> known;
  const MethodEntry* changed = nullptr;
  for (const MethodEntry& entry : config.methods) {
    known.insert(known.end(), {entry.label, entry.name});
    if (changed == nullptr && variation.changes(entry)) changed = &entry;
  }
  if (changed == nullptr) {
    throw UsageError(variation.place,
                     "this experiment has no method '" + variation.method + "'" + suggestion(variation.method, known));
  }
  const ParameterSchema& schema = method(changed->name).parameters;
  for (const MethodEntry& entry : config.methods) {
    const auto base = entry.parameters.find(variation.name);
    if (variation.changes(entry) && base != entry.parameters.end() && base->second.size() > 1) {
      throw several_values("'" + entry.label + "'", variation);
    }
  }
  Parameters checked(schema);
  checked.set(schema, variation.name, parameter_value(nonempty_list(values, "values").front()), variation.place);
  for (const TomlValue& element : values.as_list()) {
    checked.set(schema, variation.name, parameter_value(element), element.place());
    variation.values.push_back(checked.all().at(variation.name));
  }
}

Variation read_variation(const TomlValue& table, const Config& config) {
  table.allow_keys({"key", "values"}, "[[vary]]");
  const TomlValue key = table.require("key");
  const std::string text = key.as_string();
  const std::size_t dot = text.find('.');
  if (dot == std::string::npos) throw UsageError(key.place(), rule);
  Variation variation;
  variation.place = key.place();
  variation.table = text.substr(0, dot);
  variation.name = text.substr(dot + 1);
  const TomlValue values = table.require("values");
  if (variation.table == "sampling")
    read_sampling_variation(values, config, variation);
  else if (variation.table == "method")
    read_method_variation(values, config, variation);
  else
    throw UsageError(key.place(), std::string(rule) + suggestion(variation.table, {"sampling", "method"}));
  return variation;
}

}  // namespace

bool Variation::changes(const MethodEntry& entry) const {
  return table != "method" || method == entry.label || method == entry.name;
}

Sampling variation_sampling(const Variation& variation, const ParameterValue& value) {
  Sampling sampling;
  if (variation.table == "sampling") sampling_values(sampling, variation.name) = {std::get<double>(value)};
  sampling.place = variation.place;
  return sampling;
}

std::vector<Variation> read_variations(const TomlValue& document, const Config& config) {
  std::vector<Variation> variations;
  const std::optional<TomlValue> tables = document.find("vary");
  if (!tables) return variations;
  for (const TomlValue& table : tables->as_list()) variations.push_back(read_variation(table, config));
  return variations;
}

}  // namespace isobench
