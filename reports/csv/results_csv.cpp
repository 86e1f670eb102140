#include "isobench/reports/csv/results_csv.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <sstream>

#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/runs/checks.h"

namespace isobench {

namespace {

// Shortest text that reads back to the same double; whole numbers have no point.
std::string text(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }
std::string text(const std::optional<double>& value) { return value ? text(*value) : ""; }

std::string text(const std::optional<bool>& answer) { return answer ? (*answer ? "true" : "false") : ""; }

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
                                            {"reason", record.reason}};
  row["family"] = request.family;
  for (const Check& check : checks()) row[check.column] = text(passes(check, record));
  if (record.measurement) {
    for (std::size_t n = 0; n < declared_figures().size(); ++n) {
      const FigureDeclaration& figure = declared_figures()[n];
      if (figure.column != no_column) row[figure.name] = text(record.measurement->at(n));
    }
    for (const CostDeclaration& cost : cost_declarations()) row[cost.figure.name] = text(record.*cost.value);
  }
  // A requested number of vertices is met with a uniform sizing, so it has an edge length, too.
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
