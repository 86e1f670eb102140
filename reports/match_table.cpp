#include <fmt/format.h>

#include <map>

#include "reports/table_parts.h"
#include "reports/tables.h"

namespace isobench {

namespace {

// Only where it tells rows apart.
std::string seed_text(const RunRequest& request) {
  std::string text = request.seed != 1 ? fmt::format(", seed {}", request.seed) : "";
  if (request.repeat > 1) text += fmt::format(", repeat {}", request.repeat);
  return text;
}

}  // namespace

Table match_table(const Results& results) {
  Table table;
  table.title = "Matching the number of vertices";
  table.header = {"Data", "Method", "matched to", "vertices", "of", "off by %", "scale of edges", "tries"};
  table.remarks = {
      "A run is matched by scaling the edge lengths that its method is asked for until its number of vertices is "
      "within "
      "2 % of the other run's; edges are compared with h0 as it was before that."};
  std::map<std::string, const RunRecord*> by_name;
  for (const RunRecord& record : results.records) by_name[record.request.run] = &record;
  for (const RunRecord& record : results.records) {
    if (!record.match) continue;
    const RunRequest& request = record.request;
    const auto other = by_name.find(request.match_to);
    const std::string matched_to = other == by_name.end() ? request.match_to : other->second->request.label;
    const double vertices = static_cast<double>(record.measurement->vertices);
    const double off = 100.0 * (vertices / record.match->vertices - 1.0);
    TableRow row = {request.dataset, request.label + ", " + sizing_name(request.sizing) + seed_text(request),
                    matched_to};
    for (const auto& [value, print] : {std::pair{vertices, as_number()},
                                       {record.match->vertices, as_number()},
                                       {off, to_places(2)},
                                       {record.match->scale, to_significant(4)},
                                       {static_cast<double>(record.match->tries), as_number()}}) {
      row.emplace_back().figures.push_back({{value, value, value}, print});
    }
    row.back().mark = record.match->reason.empty() ? "" : " ‡ " + record.match->reason;
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace isobench
