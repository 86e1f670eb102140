#include <algorithm>
#include <map>

#include "isobench/reports/tables/table_parts.h"
#include "isobench/reports/tables/tables.h"

namespace isobench {

namespace {

double asked(const RunRecord& run) { return run.match->vertices; }
double off_percent(const RunRecord& run) { return 100.0 * (vertices(run) / asked(run) - 1.0); }
double scale(const RunRecord& run) { return run.match->scale; }
double tries(const RunRecord& run) { return run.match->tries; }

// The label of each run.
std::map<std::string, std::string> labels_of(const Results& results) {
  std::map<std::string, std::string> labels;
  for (const RunRecord& record : results.records) labels[record.request.run] = record.request.label;
  return labels;
}

// The reasons why runs could not be matched, each once.
std::string reasons(const Runs& runs) {
  std::vector<std::string> all;
  for (const RunRecord* run : runs) {
    const std::string& reason = run->match->reason;
    if (!reason.empty() && std::find(all.begin(), all.end(), reason) == all.end()) all.push_back(reason);
  }
  std::string text;
  for (const std::string& reason : all) text += (text.empty() ? " ‡ " : "; ") + reason;
  return text;
}

}  // namespace

Table match_table(const Results& results) {
  Table table;
  table.title = "Matching the number of vertices";
  table.header = {"Data", "Method", "matched to", "vertices", "target", "off by %", "edge scale", "tries"};
  table.remarks = {
      "Matching scales the requested edge lengths until both runs have the same number of vertices, within 2 %. Edges "
      "are compared with h0 before scaling."};
  const std::map<std::string, std::string> labels = labels_of(results);
  const RunGrid runs = arrange_runs(results);
  for (const std::string& dataset : runs.datasets) {
    for (const Variant& variant : runs.variants) {
      const Runs& group = find_runs(variant, dataset);
      Runs matched = finished(group);
      std::erase_if(matched, [](const RunRecord* run) { return !run->match; });
      if (matched.empty()) continue;
      const auto other = labels.find(matched.front()->request.match_to);
      table.rows.push_back({dataset, variant.name + spread_label(group, false),
                            other == labels.end() ? matched.front()->request.match_to : other->second,
                            over_all(matched, vertices, as_number()), over_all(matched, asked, as_number()),
                            over_all(matched, off_percent, to_places(2)), over_all(matched, scale, to_significant(4)),
                            with_mark(over_all(matched, tries, as_number()), reasons(matched))});
    }
  }
  return table;
}

}  // namespace isobench
