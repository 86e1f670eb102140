#include "isobench/experiments/plan/config_readers.h"

namespace isobench {

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
  if (adaptive && uniform) {  // a contradiction, which check_kind() reports
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
  if (kinds == 0) throw UsageError(sampling.place, std::string("the sampling gives no size; ") + rule);
  if (kinds > 1) throw UsageError(sampling.place, std::string("the sampling gives several sizes; ") + rule);
  if (adaptive && sampling.delta.empty()) throw UsageError(sampling.place, "epsilon is given without delta; give both");
  if (adaptive && sampling.epsilon.empty())
    throw UsageError(sampling.place, "delta is given without epsilon; give both");
}

}  // namespace isobench
