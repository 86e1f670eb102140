// plan.json, and a run's request within run.json.
#include "reports/json_values.h"

namespace isobench {

namespace {

Json parameters_to_json(const std::map<std::string, ParameterValue>& parameters) {
  Json json = Json::object();
  for (const auto& [name, value] : parameters) {
    std::visit([&json, &key = name](const auto& v) { json[key] = v; }, value);
  }
  return json;
}

std::map<std::string, ParameterValue> parameters_from_json(const Json& json) {
  std::map<std::string, ParameterValue> parameters;
  for (const auto& [name, value] : json.items()) {
    if (value.is_boolean())
      parameters[name] = value.get<bool>();
    else if (value.is_number())
      parameters[name] = value.get<double>();
    else
      parameters[name] = value.get<std::string>();
  }
  return parameters;
}

}  // namespace

Json request_to_json(const RunRequest& r) {
  return {{"run", r.run},
          {"dataset", r.dataset},
          {"dataset_checksum", r.dataset_checksum},
          {"method", r.method},
          {"method_revision", r.method_revision},
          {"label", r.label},
          {"parameters", parameters_to_json(r.parameters)},
          {"epsilon", number(r.sizing.epsilon)},
          {"delta", number(r.sizing.delta)},
          {"floor_voxels", number(r.sizing.floor)},
          {"edge_length", number(r.sizing.edge_length)},
          {"vertices", number(r.sizing.vertices)},
          {"match_scale", number(r.match_scale)},
          {"seed", r.seed},
          {"repeat", r.repeat},
          {"alone", r.alone},
          {"artefacts", r.artefacts},
          {"reference_k", r.reference_k},
          {"metrics_revision", r.metrics_revision},
          {"limit_minutes", number(r.limit_minutes)},
          {"limit_memory_gb", number(r.limit_memory_gb)}};
}

RunRequest request_from_json(const Json& json) {
  RunRequest r;
  r.run = json.at("run").get<std::string>();
  r.dataset = json.at("dataset").get<std::string>();
  r.dataset_checksum = json.at("dataset_checksum").get<std::string>();
  r.method = json.at("method").get<std::string>();
  r.method_revision = json.at("method_revision").get<int>();
  r.label = json.at("label").get<std::string>();
  r.parameters = parameters_from_json(json.at("parameters"));
  r.sizing.epsilon = optional_number(json.at("epsilon"));
  r.sizing.delta = optional_number(json.at("delta"));
  r.sizing.floor = json.at("floor_voxels").get<double>();
  r.sizing.edge_length = optional_number(json.at("edge_length"));
  r.sizing.vertices = optional_number(json.at("vertices"));
  r.match_scale = json.at("match_scale").get<double>();
  r.seed = json.at("seed").get<std::uint64_t>();
  r.repeat = json.value("repeat", 1);  // plans of before there were repeats have none
  r.alone = json.value("alone", false);
  r.artefacts = json.value("artefacts", false);
  r.reference_k = json.at("reference_k").get<int>();
  r.metrics_revision = json.at("metrics_revision").get<int>();
  r.limit_minutes = optional_number(json.at("limit_minutes"));
  r.limit_memory_gb = optional_number(json.at("limit_memory_gb"));
  return r;
}

std::string plan_to_json(const std::vector<RunRequest>& plan) {
  Json json = {{"schema_version", RunRecord::schema_version}, {"runs", Json::array()}};
  for (const RunRequest& request : plan) json["runs"].push_back(request_to_json(request));
  return json.dump(1) + "\n";
}

std::vector<RunRequest> plan_from_json(const std::string& text, const std::string& origin) {
  return located(origin, "plan", [&] {
    std::vector<RunRequest> plan;
    const Json json = Json::parse(text);
    for (const Json& request : json.at("runs")) plan.push_back(request_from_json(request));
    return plan;
  });
}

}  // namespace isobench
