#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "isobench/experiments/command_line/frozen_plan.h"
#include "isobench/experiments/command_line/report_output.h"
#include "isobench/experiments/command_line/verbs.h"
#include "isobench/experiments/plan/cell_numbers.h"
#include "isobench/experiments/plan/plan.h"
#include "isobench/experiments/runner/runner.h"
#include "isobench/reports/comparison/comparison.h"
#include "isobench/reports/runs/results.h"

namespace isobench {

namespace {

std::vector<RunRequest> selection(const std::vector<RunRequest>& plan, const std::string& glob) {
  std::vector<RunRequest> chosen;
  std::vector<std::string> names;
  std::set<std::string> needed;
  for (const RunRequest& request : plan) {
    names.push_back(request.dataset + "/" + request.label);
    if (selected(request, glob)) needed.insert({request.run, request.match_to});
  }
  // A run that is matched to another one needs that one, selected or not.
  std::copy_if(plan.begin(), plan.end(), std::back_inserter(chosen),
               [&needed](const RunRequest& request) { return needed.count(request.run) > 0; });
  if (chosen.empty()) {
    throw UsageError("--only '" + glob + "' matches no run of this experiment" + suggestion(glob, names));
  }
  return chosen;
}

void print_plan(const std::filesystem::path& folder, const std::vector<RunRequest>& cells, bool force) {
  static const std::map<RunState, std::string> words = {{RunState::missing, "to do"},
                                                        {RunState::retry, "retry"},
                                                        {RunState::done, "done"},
                                                        {RunState::elsewhere, "elsewhere"}};
  std::map<std::string, int> numbers;
  for (const RunRequest& request : cells) {
    const RunState state = run_state(folder, request);
    const std::string word = force && state == RunState::done ? "again" : words.at(state);
    ++numbers[word];
    fmt::print("{:9}  {}  {}\n", word, request.run, request.label);
  }
  std::string text;
  for (const char* word : {"to do", "retry", "again", "elsewhere", "done"}) {
    if (numbers.count(word) > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", numbers[word], word);
  }
  const bool timed = std::any_of(cells.begin(), cells.end(), [](const RunRequest& request) { return request.alone; });
  fmt::print("{} runs in {}: {}{}\n", cells.size(), folder.string(), text, timed ? "; timed, one at a time" : "");
}

// How the runs of a repeated results folder differ from those of the original.
std::string differences(const std::filesystem::path& before, const std::filesystem::path& now) {
  Results a = load_results(before);
  Results b = load_results(now);
  a.name = before.string();
  b.name = now.string();
  return comparison_text(compare(a, b), Detail::full);
}

std::string counts(const RunSummary& summary) {
  std::string text = fmt::format("{} ok", summary.ok);
  const auto add = [&text](int count, const char* what) {
    if (count > 0) text += fmt::format(", {} {}", count, what);
  };
  add(summary.failed, "failed");
  add(summary.skipped, "skipped");
  add(summary.reused, "done before");
  add(summary.elsewhere, "left to another process");
  return text;
}

int exit_code(const RunSummary& summary) {
  if (summary.failed == 0) return 0;
  const bool nothing_but_data = summary.data == summary.failed && summary.ok + summary.skipped + summary.reused == 0;
  return nothing_but_data ? 3 : 1;
}

RunOptions options_of(const RunArguments& arguments, const CommonArguments& common) {
  RunOptions options;
  options.program = std::filesystem::read_symlink("/proc/self/exe");
  options.jobs = arguments.jobs;
  options.threads = common.threads;
  options.force = arguments.force;
  return options;
}

int interrupted(const RunSummary& summary) {
  fmt::print(stderr, "isobench: stopped ({}); no run is left half-done, and the same command continues from here\n",
             counts(summary));
  return 130;
}

// Runs some cells of a results folder's plan, as a task on a cluster does. The report follows when all are done.
int run_numbered_cells(const RunArguments& arguments, const CommonArguments& common) {
  const bool more =
      arguments.only != "*" || arguments.out || !arguments.set.empty() || !arguments.seeds.empty() || arguments.quick;
  if (more || !std::filesystem::is_directory(arguments.config)) {
    throw UsageError(
        "--cells goes with a results folder, whose plan it takes as it is, and not with --only, --out, --set, --seed "
        "or --quick; `isobench run` and `isobench submit` make such a folder");
  }
  const std::vector<RunRequest> plan = read_plan(arguments.config);
  std::vector<RunRequest> cells;
  for (const std::size_t number : parse_cell_numbers(arguments.cells, plan.size())) cells.push_back(plan[number - 1]);
  if (arguments.dry_run) {
    print_plan(arguments.config, cells, arguments.force);
    return 0;
  }
  Console console(common.verbosity);
  const RunSummary summary =
      run_cells(Store(std::filesystem::canonical(arguments.config)), cells, options_of(arguments, common), console);
  if (summary.interrupted) return interrupted(summary);
  console.line(fmt::format("{}; when all cells are done, write the report: isobench report {}", counts(summary),
                           arguments.config.string()));
  return exit_code(summary);
}

}  // namespace

int run_verb(const RunArguments& arguments, const CommonArguments& common) {
  if (!arguments.cells.empty()) return run_numbered_cells(arguments, common);
  const auto [config, folder, copies] = choose_experiment(arguments);
  const std::vector<RunRequest> plan = make_plan(config);
  const std::vector<RunRequest> cells = selection(plan, arguments.only);
  if (arguments.dry_run) {
    check_folder(folder, config);
    print_plan(folder, cells, arguments.force);
    return 0;
  }
  Console console(common.verbosity);
  const Store store(folder, config, plan);
  const RunSummary summary = run_cells(store, cells, options_of(arguments, common), console);
  if (summary.interrupted) return interrupted(summary);
  const Report report = make_report(folder, common, console);
  console.line(fmt::format("{}: {}", config.name, counts(summary)));
  if (common.verbosity != Verbosity::quiet) {
    print_tables(report);
    if (copies) fmt::print("{}", differences(*copies, folder));
  }
  print_written_files(folder, report, console);
  return exit_code(summary);
}

}  // namespace isobench
