// run.json.
#include <algorithm>
#include <cmath>

#include "isobench/reports/record/figure_values.h"
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
  e.exclusive = json.value("exclusive", false);  // older records have neither
  e.job = json.value("job", "");
  return e;
}

Json dataset_to_json(const DatasetRecord& d) {
  Json direction = Json::array();
  for (int axis = 0; axis < 3; ++axis) direction.push_back(vector_to_json(d.lattice.direction.col(axis)));
  Json json = {{"title", d.title},
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
  if (d.asked_isovalue) json["asked_isovalue"] = number(*d.asked_isovalue);
  return json;
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
  if (const auto asked = json.find("asked_isovalue"); asked != json.end()) read(*asked, d.asked_isovalue.emplace());
  d.inside = json.at("inside").get<std::string>();
  d.kernel = json.at("kernel").get<std::string>();
  return d;
}

// A double holds every whole number up to this one exactly.
constexpr double largest_count = 9007199254740992.0;  // 2^53

Json figure_to_json(const FigureDeclaration& figure, const std::optional<double>& value) {
  if (!value) return nullptr;
  return figure.kind == Kind::number ? Json(*value) : Json(static_cast<std::int64_t>(*value));
}

// Unknown figures are left out; those that were not measured are null.
Json figures_to_json(const Measurement& measurement) {
  Json json = Json::object();
  for (std::size_t n = 0; n < declared_figures().size(); ++n) {
    if (!measurement.is_known(n)) continue;
    const FigureDeclaration& figure = declared_figures()[n];
    json[figure.name] = figure_to_json(figure, measurement.at(n));
  }
  return json;
}

Json histograms_to_json(const Measurement& measurement) {
  Json json = Json::object();
  for (std::size_t n = 0; n < declared_histograms().size(); ++n) {
    const Histogram& histogram = measurement.histogram_at(n);
    if (histogram.counts.empty()) continue;
    json[declared_histograms()[n].name] = {
        {"low", histogram.low}, {"high", histogram.high}, {"counts", histogram.counts}};
  }
  return json;
}

std::optional<double> figure_from_json(const FigureDeclaration& figure, const Json& json) {
  if (json.is_null()) return std::nullopt;
  if (figure.kind == Kind::number) return json.get<double>();
  const double value = figure.kind == Kind::count ? static_cast<double>(integer<std::uint64_t>(json))
                                                  : static_cast<double>(integer<std::int64_t>(json));
  if (std::abs(value) > largest_count) throw DataError(figure.name + " is too large");
  return value;
}

// A record that is older than a metric does not have its figures: they are unknown until `isobench measure` measures
// them. Figures that no metric of this program declares are ignored.
Measurement measurement_from_json(const Json& figures, const Json& histograms) {
  Measurement measurement;
  for (std::size_t n = 0; n < declared_figures().size(); ++n) {
    const FigureDeclaration& figure = declared_figures()[n];
    const auto found = figures.find(figure.name);
    if (found != figures.end())
      measurement.set_at(n, figure_from_json(figure, *found));
    else if (metric_of_figure(n).in_every_record)
      throw DataError("the figure " + figure.name + " is missing");
    else
      measurement.set_unknown(n);
  }
  for (std::size_t n = 0; n < declared_histograms().size(); ++n) {
    const auto found = histograms.find(declared_histograms()[n].name);
    if (found == histograms.end()) continue;
    Histogram& histogram = measurement.histogram_at(n);
    histogram.counts = integers<std::uint32_t>(found->at("counts"));
    // Version 0.1.0 wrote the counts of valences without the bounds.
    histogram.low = found->value("low", 0.0);
    histogram.high = found->value("high", static_cast<double>(histogram.counts.size()));
  }
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
  Json json = Json::object();
  for (const CostDeclaration& cost : cost_declarations()) json[cost.figure.name] = number(record.*cost.value);
  json["stages"] = stages_to_json(record.stages);
  return json;
}

void cost_from_json(const Json& json, RunRecord& record) {
  for (const CostDeclaration& cost : cost_declarations()) read(json.at(cost.figure.name), record.*cost.value);
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
