#include "isobench/reports/tables_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "isobench/reports/claims/claims.h"
#include "isobench/reports/runs/run_grid.h"
#include "isobench/reports/runs/timing.h"
#include "isobench/reports/tables/table_parts.h"
#include "isobench/reports/tables/tables.h"

namespace isobench {

namespace {

std::string provenance(const Results& results) {
  std::set<std::string> codes;
  std::map<std::string, std::pair<double, double>> machines;  // smallest and largest load
  for (const RunRecord& record : results.records) {
    const Environment& here = record.environment;
    codes.insert(fmt::format("isobench {} at {}{}, {} {}", here.version, here.commit.substr(0, 12),
                             here.dirty ? " with local changes" : "", here.compiler, here.build_type));
    if (record.threads == 0) continue;  // it was stopped before it could say how it ran
    const auto [place, fresh] = machines.try_emplace(timing_of(record), here.load, here.load);
    place->second = {std::min(place->second.first, here.load), std::max(place->second.second, here.load)};
  }
  std::string text;
  for (const std::string& code : codes) text += "- made by " + code + "\n";
  for (const auto& [machine, load] : machines) {
    text += fmt::format("- on {}; load average before the runs {:.1f} to {:.1f}\n", machine, load.first, load.second);
  }
  return text.empty() ? "" : text + "\n";
}

std::string gaps(const Results& results) {
  std::string text;
  for (const std::string& sentence : results.unreadable) text += "- " + sentence + "\n";
  if (!results.missing.empty()) {
    constexpr std::size_t most = 20;
    text += fmt::format("- {} of {} runs are not done yet:", results.missing.size(),
                        results.missing.size() + results.records.size());
    for (std::size_t n = 0; n < std::min(most, results.missing.size()); ++n) text += " " + results.missing[n].run;
    if (results.missing.size() > most) text += fmt::format(" and {} more", results.missing.size() - most);
    text += "\n";
  }
  return text.empty() ? "" : "**Not in these tables**\n\n" + text + "\n";
}

std::string footnotes(const Results& results) {
  std::string text;
  const auto any = [&results](auto&& test) {
    return std::any_of(results.records.begin(), results.records.end(), test);
  };
  if (any([](const RunRecord& record) { return !dagger(record).empty(); })) {
    text +=
        "† The mesh is not a closed manifold: see boundary edges, pinches and misoriented edges in the topology table. "
        "Such a mesh counts in medians and averages only if no other mesh of the same cell is closed and manifold. The "
        "number of meshes left out stands beside the figure.\n";
  }
  if (any(is_unmatched)) {
    text += "‡ The mesh does not have the number of vertices that it should be matched to: see the table of matches.\n";
  }
  if (any([](const RunRecord& record) { return !record.deterministic; })) {
    std::set<std::string> names;
    for (const RunRecord& record : results.records) {
      if (!record.deterministic) names.insert(record.request.label);
    }
    text += fmt::format("Methods that declare that they do not give the same mesh at every run: {}.\n",
                        fmt::join(names, ", "));
  }
  return text.empty() ? "" : text + "\n";
}

// Methods that promise the same mesh for the same seed but gave different ones.
std::string broken_promises(const Results& results) {
  const RunGrid runs = arrange_runs(results);
  std::string text;
  for (const std::string& dataset : runs.datasets) {
    for (const Variant& variant : runs.variants) {
      const Runs& group = find_runs(variant, dataset);
      const std::size_t meshes = different_meshes(group);
      if (meshes < 2 || !group.front()->deterministic) continue;
      text += fmt::format(
          "- {} on {}: {} different meshes in repeats of one seed, although the method promises the same mesh\n",
          variant.name, dataset, meshes);
    }
  }
  return text.empty() ? "" : "**Not deterministic**\n\n" + text + "\n";
}

}  // namespace

std::string markdown_tables(const Results& results, DatasetTables details) {
  std::string text = "# " + results.title + "\n\n" + provenance(results) + gaps(results) + broken_promises(results);
  if (!seed_table(arrange_runs(results)).empty()) {
    text +=
        "In a row with several seeds or repeats, a figure is the median of the finished runs, followed by their range "
        "(smallest–largest). Meshes that are not closed manifolds count only if all of the row are so.\n\n";
  }
  std::size_t left_out = 0;
  for (const Table& table : all_tables(results)) {
    if (table.detail && details == DatasetTables::left_out)
      ++left_out;
    else
      text += markdown(table) + "\n";
  }
  if (left_out > 0) text += fmt::format("{} of single data sets: see tables.md.\n\n", plural(left_out, "table"));
  text += claims_section(results);
  if (results.published) {
    text += heading(results.published->figures.empty() ? "The publications" : "The published figures") +
            results.published->source + ".\n\n" + results.published->note + "\n\n";
  }
  return text + footnotes(results);
}

}  // namespace isobench
