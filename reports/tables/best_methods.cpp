#include "isobench/reports/tables/best_methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/runs/checks.h"
#include "isobench/reports/runs/refinement.h"
#include "isobench/reports/runs/timing.h"
#include "isobench/reports/survey/side_by_side.h"
#include "isobench/reports/tables/table_parts.h"

namespace isobench {

namespace {

// For seconds, only runs that were timed alike count.
double median_of(const RunGrid& arrangement, const Runs& runs, const Question& question) {
  if (runs.empty()) return spread_of({}).median;
  const FigureOfRun figure = figure_of(question.figure);
  std::vector<double> values;
  for (const RunRecord* run :
       question.timed ? runs_with_timing(counted_runs(runs), arrangement.timing) : counted_runs(runs))
    values.push_back(figure(*run));
  return spread_of(std::move(values)).median;
}

// "3 of 4": how many of the runs pass.
template <class Test>
TableCell share(const Runs& runs, Test&& passes) {
  const auto count = std::count_if(runs.begin(), runs.end(), [&passes](const RunRecord* run) { return passes(*run); });
  return fmt::format("{} of {}", count, runs.size());
}

// The declaration of the figure says which value is better, and the unit.
Question ask(const std::string& name, const std::string& brief, const std::string& figure, int digits = 3,
             bool timed = false) {
  const FigureDeclaration& declared = figure_declaration(figure);
  return {name, brief, figure, declared.better == Better::larger, declared.unit, digits, timed};
}

// On how many data sets each method is best; in a tie, all are.
struct Wins {
  const Question* question = nullptr;
  std::map<std::string, int> by_method;
  int asked = 0;  ///< data sets where anything was measured
};

// With many data sets, only those count that all methods share: nobody is best where nobody else ran.
std::vector<Wins> wins_of_all(const RunGrid& runs) {
  std::vector<Wins> all;
  if (runs.variants.size() < 2) return all;
  const std::vector<std::string> datasets = has_many_datasets(runs) ? shared_datasets(runs) : runs.datasets;
  for (const Question& question : questions()) {
    Wins wins{&question, {}, 0};
    for (const std::string& dataset : datasets) {
      const Best answer = best(question, runs, dataset);
      if (!answer.names.empty()) ++wins.asked;
      for (const std::string& name : answer.names) ++wins.by_method[name];
    }
    if (wins.asked > 0) all.push_back(std::move(wins));
  }
  return all;
}

}  // namespace

const std::vector<Question>& questions() {
  static const std::vector<Question> all = {
      ask("Worst triangle (radius ratio)", "worst triangle", "radius_ratio_min"),
      ask("Average triangle (radius ratio)", "average triangle", "radius_ratio_avg"),
      ask("Smallest angle", "smallest angle", "angle_min"),
      ask("Largest angle", "largest angle", "angle_max"),
      ask("Vertices of valence 6", "valence 6", "valence_6_percent"),
      ask("Edges longer than h0", "edges within h0", "edge_over_h0_exceed_percent", 2),
      ask("Mean distance to the surface", "distance to the surface", "distance_mean"),
      ask("Time for sizing and method", "time", "seconds_total", 3, true),
      ask("Peak memory", "memory", "peak_memory_mb"),
  };
  return all;
}

Best best(const Question& question, const RunGrid& runs, const std::string& dataset) {
  const Print print = to_significant(question.digits);
  std::map<std::string, double> values;
  Best best;
  bool any = false;
  for (const Variant& variant : runs.variants) {
    const double value = median_of(runs, find_runs(variant, dataset), question);
    if (!std::isfinite(value)) continue;
    values[variant.name] = value;
    if (!any || (question.larger ? value > best.value : value < best.value)) best.value = value;
    any = true;
  }
  if (!any) return best;
  for (const Variant& variant : runs.variants) {
    const auto value = values.find(variant.name);
    if (value == values.end() || print(value->second) != print(best.value)) continue;
    best.names.push_back(variant.name);
    best.text += (best.text.empty() ? "" : ", ") + variant.name + marks(find_runs(variant, dataset));
  }
  best.text += fmt::format(": {}{}{}", print(best.value), question.unit.empty() || question.unit == "°" ? "" : " ",
                           question.unit);
  return best;
}

Table best_table(const RunGrid& all_runs) {
  const RunGrid runs = finest_runs(all_runs);
  Table table;
  table.title = "The best method for each criterion and data set";
  table.header = {"Criterion"};
  table.header.insert(table.header.end(), runs.datasets.begin(), runs.datasets.end());
  table.label_columns = 1;
  for (const Question& question : questions()) {
    TableRow row = {question.name};
    bool any = false;
    for (const std::string& dataset : runs.datasets) {
      const Best answer = best(question, runs, dataset);
      any = any || !answer.names.empty();
      row.emplace_back(answer.names.empty() ? "–" : answer.text);
    }
    if (any) table.rows.push_back(std::move(row));
  }
  if (runs.variants.size() < all_runs.variants.size())
    table.remarks.emplace_back("Of a method with several sizings, the finest mesh on each data set counts.");
  say_how_timed(runs, table);
  return table;
}

Table methods_table(const RunGrid& runs) {
  Table table;
  table.title = "Overview of the methods, over all data sets";
  table.header = {"Method",
                  "Finished",
                  "Closed manifold",
                  "Correct χ and components",
                  "Smallest radius ratio",
                  "Average radius ratio",
                  "Valence 6, %",
                  "Total vertices",
                  "Total seconds",
                  "Seconds per 100,000 vertices"};
  table.label_columns = 1;
  for (const Variant& variant : runs.variants) {
    Runs all;
    Runs done;
    for (const std::string& dataset : runs.datasets) {
      const Runs& here = find_runs(variant, dataset);
      all.insert(all.end(), here.begin(), here.end());
    }
    done = finished(all);
    TableRow row = {variant.name, share(all, [](const RunRecord& run) { return run.status == Status::ok; })};
    if (done.empty()) {
      row.insert(row.end(), table.header.size() - row.size(), TableCell("–"));
      table.rows.push_back(std::move(row));
      continue;
    }
    double smallest = 1.0;
    double average = 0.0;
    double six = 0.0;
    double vertices = 0.0;
    double seconds = 0.0;
    for (const RunRecord* run : done) {
      smallest = std::min(smallest, run->measurement->number("radius_ratio_min"));
      average += run->measurement->number("radius_ratio_avg") / static_cast<double>(done.size());
      six += run->measurement->number("valence_6_percent") / static_cast<double>(done.size());
      vertices += run->measurement->number("vertices");
      seconds += run->seconds_total;
    }
    row.push_back(share(done, [](const RunRecord& run) { return is_closed_manifold(run); }));
    Runs proven = done;
    std::erase_if(proven, [](const RunRecord* run) { return !run->measurement->figure("euler_reference"); });
    const auto is_right = [](const RunRecord& run) { return passes(check("right_topology"), run) == true; };
    row.push_back(proven.empty() ? TableCell("–") : share(proven, is_right));
    row.push_back(number_cell(smallest, to_significant(3)));
    row.push_back(number_cell(average, to_significant(3)));
    row.push_back(number_cell(six, to_significant(3)));
    row.push_back(number_cell(vertices, as_number()));
    // A sum without some of the runs would be too small.
    const bool alike = runs_with_timing(done, runs.timing).size() == done.size();
    row.push_back(alike ? number_cell(seconds, to_significant(3)) : TableCell("§"));
    row.push_back(alike ? number_cell(1e5 * seconds / vertices, to_significant(3)) : TableCell("§"));
    table.rows.push_back(std::move(row));
  }
  table.remarks = {
      "Averages are over the finished runs, with equal weights. A mesh has the correct χ and components if it is a "
      "closed manifold and both numbers are those of the surface F = c: see the reference in the topology table, "
      "without which a run does not count there."};
  say_how_timed(runs, table);
  return table;
}

std::vector<std::string> best_sentences(const RunGrid& runs) {
  const RunGrid finest = finest_runs(runs);
  std::vector<std::string> sentences;
  for (const Wins& won : wins_of_all(finest)) {
    const std::string& name = won.question->name;
    if (won.asked > 1 && won.by_method.size() == 1 && won.by_method.begin()->second == won.asked) {
      sentences.push_back(fmt::format("{}: {} on all {} data sets.", name, won.by_method.begin()->first, won.asked));
      continue;
    }
    std::string text;
    for (const Variant& variant : finest.variants) {
      const auto count = won.by_method.find(variant.name);
      if (count == won.by_method.end()) continue;
      text += fmt::format("{}{} on {}", text.empty() ? "" : ", ", variant.name, count->second);
    }
    sentences.push_back(fmt::format("{}: {} of {} data set{}.", name, text, won.asked, won.asked == 1 ? "" : "s"));
  }
  return sentences;
}

std::string best_line(const RunGrid& runs) {
  const RunGrid finest = finest_runs(runs);
  std::map<std::string, std::vector<std::string>> best_at;
  for (const Wins& won : wins_of_all(finest)) {
    const int most = std::max_element(won.by_method.begin(), won.by_method.end(), [](const auto& a, const auto& b) {
                       return a.second < b.second;
                     })->second;
    const auto winners = std::count_if(won.by_method.begin(), won.by_method.end(),
                                       [most](const auto& method) { return method.second == most; });
    if (winners > 2) continue;  // that many are equal is no news
    const std::string count = most == won.asked ? "" : fmt::format(" ({} of {})", most, won.asked);
    for (const auto& [method, times] : won.by_method) {
      if (times == most) best_at[method].push_back(won.question->brief + count);
    }
  }
  std::vector<std::string> parts;
  for (const Variant& variant : finest.variants) {
    const auto found = best_at.find(variant.name);
    if (found != best_at.end()) parts.push_back(fmt::format("{}: {}", variant.name, fmt::join(found->second, ", ")));
  }
  if (parts.empty()) return "";
  return fmt::format("Best{} – {}.", runs.datasets.size() == 1 ? "" : " on the most data sets", fmt::join(parts, "; "));
}

}  // namespace isobench
