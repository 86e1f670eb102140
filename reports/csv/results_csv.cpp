#include "isobench/reports/csv/results_csv.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <sstream>

#include "isobench/reports/record/figures.h"

namespace isobench {

namespace {

// Shortest text that reads back to the same double.
std::string text(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }
std::string text(const std::optional<double>& value) { return value ? text(*value) : ""; }

std::string csv_field(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
  std::string result = "\"";
  for (const char c : field) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + "\"";
}

std::string parameters_text(const ParameterValues& parameters) {
  std::string result;
  for (const auto& [name, value] : parameters) {
    result += (result.empty() ? "" : ";") + name + "=" + to_string(value);
  }
  return result;
}

std::map<std::string, std::string> fields(const RunRecord& record) {
  const RunRequest& request = record.request;
  std::map<std::string, std::string> row = {{"run", request.run},
                                            {"dataset", request.dataset},
                                            {"method", request.method},
                                            {"label", request.label},
                                            {"parameters", parameters_text(*request.parameters)},
                                            {"epsilon", text(request.sizing.epsilon)},
                                            {"delta", text(request.sizing.delta)},
                                            {"edge_length", text(request.sizing.edge_length)},
                                            {"match_to", request.match_to},
                                            {"match_vertices", record.match ? text(record.match->vertices) : ""},
                                            {"match_scale", text(record.match ? record.match->scale : 1.0)},
                                            {"match_reason", record.match ? record.match->reason : ""},
                                            {"seed", fmt::format("{}", request.seed)},
                                            {"repeat", fmt::format("{}", request.repeat)},
                                            {"mesh_checksum", record.mesh_checksum},
                                            {"host", record.environment.host},
                                            {"exclusive", record.environment.exclusive ? "true" : "false"},
                                            {"status", to_string(record.status)},
                                            {"reason", record.reason},
                                            {"reference_k", fmt::format("{}", request.reference_k)}};
  if (record.measurement) {
    visit_figures(*record.measurement, [&row](const char* name, const auto& value) {
      if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>)
        row[name] = text(value);
      else
        row[name] = fmt::format("{}", value);
    });
    row["seconds_prepare"] = text(record.seconds_prepare);
    row["seconds_sizing"] = text(record.seconds_sizing);
    row["seconds_method"] = text(record.seconds_method);
    row["seconds_total"] = text(record.seconds_total);
    row["peak_memory_mb"] = text(record.peak_memory_mb);
  }
  // A request for a number of vertices is uniform too; the length it came to is what is comparable.
  if (request.sizing.vertices && record.sizing) row["edge_length"] = text(record.sizing->largest);
  return row;
}

}  // namespace

void write_results_csv(std::ostream& file, const std::vector<RunRecord>& records) {
  bool first_name = true;
  for (const CsvColumn& column : csv_columns()) {
    file << (first_name ? "" : ",") << column.name;
    first_name = false;
  }
  file << '\n';
  for (const RunRecord& record : records) {
    std::map<std::string, std::string> row = fields(record);
    std::string line;
    bool first = true;
    for (const CsvColumn& column : csv_columns()) {
      if (!first) line += ",";
      line += csv_field(row[column.name]);
      first = false;
    }
    file << line << '\n';
  }
}

std::string results_csv(const std::vector<RunRecord>& records) {
  std::ostringstream text;
  write_results_csv(text, records);
  return text.str();
}

}  // namespace isobench
