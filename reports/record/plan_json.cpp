// plan.json, and a run's request within run.json.
#include <map>
#include <sstream>

#include "isobench/foundation/names.h"
#include "isobench/reports/record/json_values.h"

namespace isobench {

namespace {

Json parameters_to_json(const ParameterValues& parameters) {
  Json json = Json::object();
  for (const auto& [name, value] : parameters) {
    std::visit([&json, &key = name](const auto& v) { json[key] = v; }, value);
  }
  return json;
}

ParameterValues parameters_from_json(const Json& json) {
  ParameterValues parameters;
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
          {"family", r.family},
          {"method", r.method},
          {"method_revision", r.method_revision},
          {"label", r.label},
          {"parameters", parameters_to_json(*r.parameters)},
          {"epsilon", number(r.sizing.epsilon)},
          {"delta", number(r.sizing.delta)},
          {"floor_voxels", number(r.sizing.floor)},
          {"edge_length", number(r.sizing.edge_length)},
          {"vertices", number(r.sizing.vertices)},
          {"match_to", r.match_to},
          {"seed", r.seed},
          {"repeat", r.repeat},
          {"alone", r.alone},
          {"artefacts", r.artefacts},
          {"metrics_of_use", r.metrics_of_use},
          {"aside", r.aside},
          {"min_component", number(r.min_component)},
          {"metrics_revision", r.metrics_revision},
          {"limit_minutes", number(r.limit_minutes)},
          {"limit_memory_gb", number(r.limit_memory_gb)}};
}

namespace {

// A results folder may come from anybody. These values become names of folders that are made, replaced and removed, and
// determine how much is computed.
void check(const RunRequest& r) {
  for (const std::string& name : {std::filesystem::path(r.dataset).stem().string(), r.method}) {
    if (!is_plain_name(name)) throw DataError("'" + name + "' cannot be the name of a dataset or a method");
  }
  for (const std::string& name : {r.run, r.match_to.empty() ? r.run : r.match_to}) {
    if (!is_plain_name(name, 240)) throw DataError("'" + name + "' cannot be the name of a run's folder");
  }
  if (r.repeat < 1) throw DataError(fmt::format("repeat is {}, not at least 1", r.repeat));
}

}  // namespace

// Keys of older versions that no longer mean anything, such as reference_k, are ignored.
RunRequest request_from_json(const Json& json) {
  RunRequest r;
  r.run = json.at("run").get<std::string>();
  r.dataset = json.at("dataset").get<std::string>();
  r.dataset_checksum = json.at("dataset_checksum").get<std::string>();
  r.family = json.value("family", "");  // older plans have none
  r.method = json.at("method").get<std::string>();
  r.method_revision = integer<int>(json.at("method_revision"));
  r.label = json.at("label").get<std::string>();
  r.parameters = parameters_from_json(json.at("parameters"));
  r.sizing.epsilon = optional_number(json.at("epsilon"));
  r.sizing.delta = optional_number(json.at("delta"));
  r.sizing.floor = json.at("floor_voxels").get<double>();
  r.sizing.edge_length = optional_number(json.at("edge_length"));
  r.sizing.vertices = optional_number(json.at("vertices"));
  r.match_to = json.value("match_to", "");  // older plans have none
  r.seed = integer<std::uint64_t>(json.at("seed"));
  if (json.contains("repeat")) r.repeat = integer<int>(json.at("repeat"));  // older plans have none
  r.alone = json.value("alone", false);
  r.artefacts = json.value("artefacts", false);
  r.metrics_of_use = json.value("metrics_of_use", false);  // older plans have none
  r.aside = json.value("aside", false);
  r.min_component = json.value("min_component", 0.0);  // older plans have none
  r.metrics_revision = integer<int>(json.at("metrics_revision"));
  r.limit_minutes = optional_number(json.at("limit_minutes"));
  r.limit_memory_gb = optional_number(json.at("limit_memory_gb"));
  check(r);
  return r;
}

// Writes run by run: the JSON of a hundred thousand runs would take several times the memory of the plan.
void write_plan(std::ostream& file, const std::vector<RunRequest>& plan) {
  file << "{\n \"schema_version\": " << RunRecord::schema_version << ",\n \"runs\": [";
  for (std::size_t n = 0; n < plan.size(); ++n) {
    std::istringstream lines(text_of(request_to_json(plan[n])));
    if (n > 0) file << ',';
    for (std::string line; std::getline(lines, line);) file << "\n  " << line;
  }
  file << (plan.empty() ? "]\n}\n" : "\n ]\n}\n");
}

std::string plan_to_json(const std::vector<RunRequest>& plan) {
  std::ostringstream text;
  write_plan(text, plan);
  return text.str();
}

std::vector<RunRequest> plan_from_json(const std::string& text, const std::string& origin) {
  return located(origin, "plan", [&] {
    std::vector<RunRequest> plan;
    // Most runs share their parameters. They are found by text: 0.0 and -0.0 are equal, but not the same parameter.
    std::map<std::string, SharedValue<ParameterValues>> parameters;
    bool runs = false;
    // Converts each run once it is parsed and drops its JSON: the JSON of a hundred thousand runs would take several
    // times the memory of the plan.
    const auto take_over = [&](int depth, Json::parse_event_t event, Json& parsed) {
      if (depth == 1 && event == Json::parse_event_t::key) runs = parsed == "runs";
      if (!runs || depth != 2 || event != Json::parse_event_t::object_end) return true;
      RunRequest& request = plan.emplace_back(request_from_json(parsed));
      request.parameters = parameters.try_emplace(parsed.at("parameters").dump(), request.parameters).first->second;
      return false;
    };
    const Json json = Json::parse(text, take_over);
    if (!json.at("runs").is_array() || !json.at("runs").empty()) throw DataError("'runs' is no list of runs");
    return plan;
  });
}

}  // namespace isobench
