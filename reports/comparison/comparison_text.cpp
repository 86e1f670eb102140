// What `isobench compare` prints.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "isobench/reports/comparison/comparison.h"
#include "isobench/reports/tables/table_parts.h"
#include "isobench/reports/text/markdown.h"

namespace isobench {

namespace {

std::string circumstance_names(const Comparison& comparison) {
  std::set<std::string> names;
  for (const CircumstanceChange& change : comparison.circumstances) names.insert(change.what);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string not_compared(const char* side, const std::set<std::string>& figures, const std::string& reason) {
  if (figures.empty()) return "";
  return fmt::format("{} has no {}: {}. {} not compared.\n", side, fmt::join(figures, ", "), reason,
                     figures.size() == 1 ? "It is" : "They are");
}

// "A has no area, volume: its records are older than these figures. They are not compared.\n", and the same of figures
// that its experiment did not ask for; "" if both sides have all figures.
std::string older_side(const char* side, const std::set<std::string>& unknown) {
  std::set<std::string> older;
  std::set<std::string> not_asked_for;
  for (const std::string& figure : unknown) {
    const bool on_request = metric_of_figure(figure_index(figure)).when == When::on_request;
    (on_request ? not_asked_for : older).insert(figure);
  }
  return not_compared(side, older,
                      older.size() == 1 ? "its records are older than this figure"
                                        : "its records are older than these figures") +
         not_compared(side, not_asked_for, "its runs were made without metrics_of_use");
}

std::string older_sides(const Comparison& comparison) {
  return older_side("A", comparison.unknown_in_a) + older_side("B", comparison.unknown_in_b);
}

// The verdict in one sentence.
std::string verdict(const Comparison& comparison) {
  const std::string runs = plural(comparison.matched, "run");
  const std::string circumstances = circumstance_names(comparison);
  const std::string undone =
      comparison.undone == 0 ? "" : fmt::format("; {} done on neither side", plural(comparison.undone, "planned run"));
  if (comparison.same()) {
    return fmt::format("{} the same on both sides, except for seconds and memory{}{}.\n",
                       runs + (comparison.matched == 1 ? " is" : " are"),
                       circumstances.empty() ? "" : " (other circumstances: " + circumstances + "; -v shows them)",
                       undone);
  }
  std::set<std::string> differing;
  for (const Difference& difference : comparison.differences) differing.insert(difference.run);
  std::string text =
      comparison.matched == 0 ? "No run is in both" : fmt::format("{} of {} in both differ", differing.size(), runs);
  if (!comparison.only_a.empty()) text += fmt::format(", {} only in A", plural(comparison.only_a.size(), "run"));
  if (!comparison.only_b.empty()) text += fmt::format(", {} only in B", plural(comparison.only_b.size(), "run"));
  if (!comparison.unreadable.empty()) text += ", " + plural(comparison.unreadable.size(), "damaged record");
  return fmt::format("{}{}.\n", text, undone);
}

std::string differences(const Comparison& comparison) {
  if (comparison.differences.empty()) return "";
  MarkdownTable table({"Run", "Figure", "A", "B", "relative"});
  for (const Difference& each : comparison.differences) {
    table.add({each.run, each.figure, each.a, each.b, significant(each.relative, 2)});
  }
  std::string text = heading("What differs") + table.text();
  if (!comparison.not_deterministic.empty()) {
    text += fmt::format("\nThe methods of these runs do not promise the same mesh every time: {}.\n",
                        fmt::join(comparison.not_deterministic, ", "));
  }
  return text + "\n";
}

std::string missing(const Comparison& comparison) {
  std::string text;
  for (const Unmatched& run : comparison.only_a) text += fmt::format("- only in A: {} ({})\n", run.run, run.why);
  for (const Unmatched& run : comparison.only_b) text += fmt::format("- only in B: {} ({})\n", run.run, run.why);
  for (const std::string& sentence : comparison.unreadable) text += fmt::format("- {}\n", sentence);
  return text.empty() ? "" : heading("Runs without a counterpart") + text + "\n";
}

std::string ratio(double a, double b) { return a > 0.0 ? significant(b / a, 3) : "–"; }

std::string costs(const Comparison& comparison) {
  if (comparison.costs.empty()) return "";
  MarkdownTable table({"Run", "s in A", "s in B", "B / A", "peak MB in A", "peak MB in B", "B / A"});
  for (const CostPair& cost : comparison.costs) {
    table.add({cost.run, significant(cost.seconds_a, 3), significant(cost.seconds_b, 3),
               ratio(cost.seconds_a, cost.seconds_b), significant(cost.memory_mb_a, 3),
               significant(cost.memory_mb_b, 3), ratio(cost.memory_mb_a, cost.memory_mb_b)});
  }
  return heading("Seconds (sizing + method) and memory") + table.text() + "\n";
}

std::string circumstances(const Comparison& comparison) {
  if (comparison.circumstances.empty()) return "";
  MarkdownTable table({"What", "A", "B", "runs"});
  for (const CircumstanceChange& change : comparison.circumstances) {
    table.add({change.what, change.a, change.b, fmt::format("{}", change.runs)});
  }
  return heading("Circumstances that differ") + table.text() + "\n";
}

}  // namespace

std::string comparison_text(const Comparison& comparison, Detail detail) {
  if (comparison.same() && detail == Detail::brief) return verdict(comparison) + older_sides(comparison);
  std::string text = fmt::format("# A: {}, B: {}\n\n", comparison.name_a, comparison.name_b);
  text += verdict(comparison) + older_sides(comparison) + "\n";
  text += differences(comparison) + missing(comparison) + costs(comparison) + circumstances(comparison);
  text.pop_back();  // each part ends with an empty line
  return text;
}

}  // namespace isobench
