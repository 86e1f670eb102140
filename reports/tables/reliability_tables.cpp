// How often meshes pass the checks, and which data sets do not.
#include <fmt/format.h>

#include <algorithm>

#include "isobench/reports/statistics/sample.h"
#include "isobench/reports/survey/survey.h"
#include "isobench/reports/tables/survey_tables.h"
#include "isobench/reports/tables/table_parts.h"

namespace isobench {

namespace {

// "998 of 1000 (99.3–99.9 %)"; "–" if no data set was measured.
TableCell pass_cell(const PassCount& count) {
  if (count.asked == 0) return count.not_measured == 0 ? "–" : "not measured";
  const Interval sure = wilson_interval(count.passed, count.asked);
  const auto percent = [](double share) { return fmt::format("{:.3g}", 100.0 * share); };
  TableCell cell = fmt::format("{} of {}", count.passed, count.asked);
  cell.note = fmt::format("{}–{} %", percent(sure.low), percent(sure.high));
  if (count.not_measured > 0) cell.note += fmt::format(", {} not measured", count.not_measured);
  return cell;
}

// "990 ok, 8 timeout, 2 failed".
std::string ends_text(const Tally& tally) {
  std::vector<std::string> parts;
  for (const auto& [status, count] : tally.ends) parts.push_back(fmt::format("{} {}", count, to_string(status)));
  return fmt::format("{}", fmt::join(parts, ", "));
}

void add_counts(const Tally& tally, TableRow& row) {
  row.emplace_back(fmt::format("{}", tally.datasets));
  row.emplace_back(ends_text(tally));
  for (const PassCount& count : tally.checks) row.push_back(pass_cell(count));
}

Table counted_table(const std::string& title, std::vector<std::string> labels) {
  Table table;
  table.title = title;
  table.label_columns = labels.size();
  table.header = std::move(labels);
  table.header.insert(table.header.end(), {"Data sets", "Ended"});
  for (const Check& check : checks()) table.header.push_back(check.name);
  table.remarks = {
      "Each cell: how many data sets pass, of how many, and Wilson's 95 % interval of the share. A data set without a "
      "mesh does not pass. One whose figures were not measured counts neither way. With several seeds or repeats, all "
      "runs must pass."};
  return table;
}

}  // namespace

Table reliability_table(const RunGrid& runs) {
  Table table = counted_table("Reliability", {"Method"});
  for (const Variant* method : surveyed(runs)) {
    TableRow row = {method->name};
    add_counts(tally(runs, *method), row);
    table.rows.push_back(std::move(row));
  }
  for (const Check& check : checks()) table.remarks.push_back("`" + check.name + "`: " + check.definition);
  return table;
}

Table family_reliability_table(const RunGrid& runs) {
  Table table = counted_table("Reliability by family", {"Family", "Method"});
  for (const Variant* method : surveyed(runs)) {
    for (const std::string& family : families_of(runs)) {
      const Tally counts = tally(runs, *method, family);
      if (counts.datasets == 0) continue;
      TableRow row = {family, method->name};
      add_counts(counts, row);
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

Table outlier_table(const RunGrid& runs) {
  constexpr std::size_t most_names = 10;
  Table table;
  table.title = "Data sets that do not pass";
  table.header = {"Method", "Check", "Not passed", "Data sets"};
  for (const Variant* method : surveyed(runs)) {
    const Tally counts = tally(runs, *method);
    for (std::size_t n = 0; n < checks().size(); ++n) {
      const std::vector<std::string>& names = counts.checks[n].not_passed;
      if (names.empty()) continue;
      const auto end = names.begin() + static_cast<std::ptrdiff_t>(std::min(most_names, names.size()));
      std::string list = fmt::format("{}", fmt::join(names.begin(), end, ", "));
      if (names.size() > most_names) list += fmt::format(" and {} more", names.size() - most_names);
      table.rows.push_back(
          {method->name, checks()[n].name, fmt::format("{} of {}", names.size(), counts.checks[n].asked), list});
    }
  }
  table.remarks = {
      fmt::format("At most {} data sets are named, in the order of the plan. results.csv has a column for each check.",
                  most_names)};
  return table;
}

std::string sound_sentence(const RunGrid& runs) {
  std::vector<std::string> parts;
  for (const Variant* method : surveyed(runs)) {
    const PassCount sound = tally(runs, *method).sound;
    if (sound.asked > 0) parts.push_back(fmt::format("{} {} of {}", method->name, sound.passed, sound.asked));
  }
  if (parts.empty()) return "";
  return fmt::format("Sound meshes (closed manifold, right topology, no self-intersections): {}.",
                     fmt::join(parts, ", "));
}

}  // namespace isobench
