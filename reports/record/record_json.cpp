// run.json.
#include <algorithm>

#include "isobench/reports/record/figures.h"
#include "isobench/reports/record/json_values.h"

namespace isobench {

namespace {

Json vector_to_json(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }
Eigen::Vector3d vector_from_json(const Json& j) {
  return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()};
}

Json environment_to_json(const Environment& e) {
  return {
      {"version", e.version},       {"commit", e.commit},        {"dirty", e.dirty},         {"compiler", e.compiler},
      {"build_type", e.build_type}, {"libraries", *e.libraries}, {"host", e.host},           {"cpu", e.cpu},
      {"cores", e.cores},           {"load", number(e.load)},    {"exclusive", e.exclusive}, {"job", e.job}};
}

Environment environment_from_json(const Json& json) {
  Environment e;
  e.version = json.at("version").get<std::string>();
  e.commit = json.at("commit").get<std::string>();
  e.dirty = json.at("dirty").get<bool>();
  e.compiler = json.at("compiler").get<std::string>();
  e.build_type = json.at("build_type").get<std::string>();
  e.libraries = json.at("libraries").get<LibraryVersions>();
  e.host = json.at("host").get<std::string>();
  e.cpu = json.at("cpu").get<std::string>();
  e.cores = integer<int>(json.at("cores"));
  read(json.at("load"), e.load);
  e.exclusive = json.value("exclusive", false);  // records of before there were clusters have neither
  e.job = json.value("job", "");
  return e;
}

Json dataset_to_json(const DatasetRecord& d) {
  Json direction = Json::array();
  for (int axis = 0; axis < 3; ++axis) direction.push_back(vector_to_json(d.lattice.direction.col(axis)));
  return {{"title", d.title},
          {"source", d.source},
          {"preparation", d.preparation},
          {"size", d.lattice.size},
          {"spacing", vector_to_json(d.lattice.spacing)},
          {"origin", vector_to_json(d.lattice.origin)},
          {"direction", direction},
          {"space", d.lattice.space},
          {"isovalue", number(d.isovalue)},
          {"inside", d.inside},
          {"kernel", d.kernel}};
}

DatasetRecord dataset_from_json(const Json& json) {
  DatasetRecord d;
  d.title = json.at("title").get<std::string>();
  d.source = json.at("source").get<std::string>();
  d.preparation = json.at("preparation").get<std::vector<std::string>>();
  const std::vector<int> size = integers<int>(json.at("size"));
  if (size.size() != 3) throw DataError("a lattice has three sizes");
  std::copy(size.begin(), size.end(), d.lattice.size.begin());
  d.lattice.spacing = vector_from_json(json.at("spacing"));
  d.lattice.origin = vector_from_json(json.at("origin"));
  for (int axis = 0; axis < 3; ++axis) d.lattice.direction.col(axis) = vector_from_json(json.at("direction").at(axis));
  d.lattice.space = json.at("space").get<std::string>();
  read(json.at("isovalue"), d.isovalue);
  d.inside = json.at("inside").get<std::string>();
  d.kernel = json.at("kernel").get<std::string>();
  return d;
}

Json figures_to_json(const Measurement& measurement) {
  Json json = Json::object();
  visit_figures(measurement, [&](const char* name, const auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>)
      json[name] = number(value);
    else
      json[name] = value;
  });
  return json;
}

Json histograms_to_json(const Measurement& measurement) {
  Json json = Json::object();
  visit_histograms(measurement, [&](const char* name, const Histogram& histogram) {
    json[name] = {{"low", histogram.low}, {"high", histogram.high}, {"counts", histogram.counts}};
  });
  json["valence"] = {{"counts", measurement.valence.counts}};
  return json;
}

Measurement measurement_from_json(const Json& figures, const Json& histograms) {
  Measurement measurement;
  visit_figures(measurement, [&](const char* name, auto& value) {
    // Figures that came after the record was written, by metrics of a later revision, are unknown, and taken by
    // `isobench measure`.
    const std::string figure = name;
    const bool later = (figure.starts_with("edge_over_own_h0") || figure.starts_with("distance_from_surface")) &&
                       !figures.contains(figure);
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>) {
      if (later) value = std::numeric_limits<double>::quiet_NaN();
    }
    if (!later) read(figures.at(name), value);
  });
  visit_histograms(measurement, [&](const char* name, Histogram& histogram) {
    const Json& json = histograms.at(name);
    histogram.low = json.at("low").get<double>();
    histogram.high = json.at("high").get<double>();
    histogram.counts = integers<std::uint32_t>(json.at("counts"));
  });
  measurement.valence.counts = integers<std::size_t>(histograms.at("valence").at("counts"));
  return measurement;
}

Json stages_to_json(const std::vector<StageTime>& stages) {
  Json json = Json::array();
  for (const StageTime& stage : stages) {
    json.push_back({{"name", stage.name}, {"wall", number(stage.wall_seconds)}, {"cpu", number(stage.cpu_seconds)}});
  }
  return json;
}

Json seconds_to_json(const RunRecord& record) {
  return {{"seconds_prepare", number(record.seconds_prepare)}, {"seconds_sizing", number(record.seconds_sizing)},
          {"seconds_method", number(record.seconds_method)},   {"seconds_total", number(record.seconds_total)},
          {"peak_memory_mb", number(record.peak_memory_mb)},   {"stages", stages_to_json(record.stages)}};
}

void cost_from_json(const Json& json, RunRecord& record) {
  read(json.at("seconds_prepare"), record.seconds_prepare);
  read(json.at("seconds_sizing"), record.seconds_sizing);
  read(json.at("seconds_method"), record.seconds_method);
  read(json.at("seconds_total"), record.seconds_total);
  read(json.at("peak_memory_mb"), record.peak_memory_mb);
  record.stages.reserve(json.at("stages").size());
  for (const Json& stage : json.at("stages")) {
    StageTime time{stage.at("name").get<std::string>(), 0.0, 0.0};
    read(stage.at("wall"), time.wall_seconds);
    read(stage.at("cpu"), time.cpu_seconds);
    record.stages.push_back(std::move(time));
  }
}

Status status_from(const std::string& text) {
  for (const Status status : {Status::ok, Status::failed, Status::timeout, Status::out_of_memory, Status::skipped}) {
    if (to_string(status) == text) return status;
  }
  throw DataError("unknown status '" + text + "'");
}

Json record_to_json(const RunRecord& record) {
  Json json = {{"schema_version", RunRecord::schema_version},
               {"status", to_string(record.status)},
               {"reason", record.reason},
               {"started", record.started},
               {"request", request_to_json(record.request)},
               {"threads", record.threads},
               {"deterministic", record.deterministic},
               {"environment", environment_to_json(record.environment)}};
  if (record.dataset) json["dataset"] = dataset_to_json(*record.dataset);
  if (record.match) {
    json["match"] = {{"vertices", number(record.match->vertices)},
                     {"scale", number(record.match->scale)},
                     {"tries", record.match->tries},
                     {"reason", record.match->reason}};
  }
  if (record.sizing) {
    json["sizing"] = {{"uniform", record.sizing->uniform},
                      {"floor", number(record.sizing->floor)},
                      {"smallest", number(record.sizing->smallest)},
                      {"largest", number(record.sizing->largest)}};
  }
  json["cost"] = seconds_to_json(record);
  json["counters"] = Json::object();
  for (const auto& [name, value] : record.counters) json["counters"][name] = number(value);
  json["notes"] = record.notes;
  if (!record.mesh_checksum.empty()) json["mesh_checksum"] = record.mesh_checksum;
  if (record.measured_again) {
    json["measured_again"] = {{"when", record.measured_again->when},
                              {"commit", record.measured_again->commit},
                              {"dirty", record.measured_again->dirty}};
  }
  if (record.measurement) {
    json["figures"] = figures_to_json(*record.measurement);
    json["histograms"] = histograms_to_json(*record.measurement);
  }
  json["traces"] = Json::object();
  for (const auto& [name, values] : record.traces) {
    Json& trace = json["traces"][name] = Json::array();
    for (const double value : values) trace.push_back(number(value));
  }
  return json;
}

RunRecord record_from(const Json& json) {
  const int schema = integer<int>(json.at("schema_version"));
  if (schema != RunRecord::schema_version) {
    throw DataError(
        fmt::format("its schema is version {}, this program reads version {}", schema, RunRecord::schema_version));
  }
  RunRecord record;
  record.status = status_from(json.at("status").get<std::string>());
  record.reason = json.at("reason").get<std::string>();
  record.started = json.at("started").get<std::string>();
  record.request = request_from_json(json.at("request"));
  record.threads = integer<int>(json.at("threads"));
  record.deterministic = json.at("deterministic").get<bool>();
  record.environment = environment_from_json(json.at("environment"));
  if (json.contains("dataset")) record.dataset = dataset_from_json(json.at("dataset"));
  if (json.contains("match")) {
    const Json& match = json.at("match");
    read(match.at("vertices"), record.match.emplace().vertices);
    read(match.at("scale"), record.match->scale);
    record.match->tries = integer<int>(match.at("tries"));
    record.match->reason = match.at("reason").get<std::string>();
  }
  if (json.contains("sizing")) {
    const Json& sizing = json.at("sizing");
    record.sizing.emplace().uniform = sizing.at("uniform").get<bool>();
    read(sizing.at("floor"), record.sizing->floor);
    read(sizing.at("smallest"), record.sizing->smallest);
    read(sizing.at("largest"), record.sizing->largest);
  }
  cost_from_json(json.at("cost"), record);
  std::map<std::string, double> counters;
  for (const auto& [name, value] : json.at("counters").items()) read(value, counters[name]);
  record.counters = counters;
  record.notes = json.at("notes").get<std::vector<std::string>>();
  record.mesh_checksum = json.value("mesh_checksum", "");
  if (json.contains("measured_again")) {
    const Json& again = json.at("measured_again");
    record.measured_again = {again.at("when").get<std::string>(), again.at("commit").get<std::string>(),
                             again.at("dirty").get<bool>()};
  }
  if (record.status == Status::ok) {
    record.measurement = measurement_from_json(json.at("figures"), json.at("histograms"));
  }
  for (const auto& [name, values] : json.at("traces").items()) {
    std::vector<double>& trace = record.traces[name];
    trace.reserve(values.size());
    for (const Json& value : values) read(value, trace.emplace_back());
  }
  return record;
}

}  // namespace

std::string to_json(const RunRecord& record) { return text_of(record_to_json(record)); }

std::string to_json(const Measurement& measurement) { return text_of(figures_to_json(measurement)); }

RunRecord record_from_json(const std::string& text, const std::string& origin) {
  return located(origin, "run record", [&] { return record_from(Json::parse(text)); });
}

}  // namespace isobench
