#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

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
  // What is matched to another run needs that one, selected or not.
  std::copy_if(plan.begin(), plan.end(), std::back_inserter(chosen),
               [&needed](const RunRequest& request) { return needed.count(request.run) > 0; });
  if (chosen.empty())
    throw UsageError("--only '" + glob + "' names no run of this experiment" + suggestion(glob, names));
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

// What is to be run, and where to.
struct Source {
  std::filesystem::path config;
  std::string name;  ///< of the experiment; "" where the config's file says it
  std::filesystem::path out;
  std::optional<std::filesystem::path> again_of;  ///< the results folder that is made again elsewhere
};

Source source_of(const RunArguments& arguments) {
  namespace fs = std::filesystem;
  if (!fs::is_directory(arguments.config)) return {arguments.config, "", arguments.out.value_or("results"), {}};
  const fs::path folder = fs::canonical(arguments.config);
  if (!fs::exists(folder / "config.toml")) {
    throw UsageError(arguments.config.string() +
                     " is a folder without a config.toml, so it holds no results; give a "
                     "config or a results folder");
  }
  Source source{folder / "config.toml", folder.filename().string(), arguments.out.value_or(folder.parent_path()), {}};
  const fs::path target = source.out / source.name;
  if (!fs::exists(target) || !fs::equivalent(target, folder)) source.again_of = folder;
  return source;
}

std::string what_differs(const std::filesystem::path& before, const std::filesystem::path& now) {
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

// The report, with what is missing from it and, last, where to look.
Report make_report(const std::filesystem::path& folder, const CommonArguments& common, Console& console) {
  if (!common.tables_only) console.update("making the report", -1.0);
  Report report = write_report_locked(folder, common.tables_only ? ReportParts::tables : ReportParts::all);
  console.clear();
  return report;
}

void say_written(const std::filesystem::path& folder, const Report& report, Console& console) {
  for (const std::string& sentence : report.missing) console.line(sentence);
  std::string text;
  for (const std::string& name : report.written) {
    text += fmt::format("{}{}/{}", text.empty() ? "" : ", ", folder.string(), name);
  }
  console.line("written: " + text);
}

int exit_code(const RunSummary& summary) {
  if (summary.failed == 0) return 0;
  const bool nothing_but_data = summary.data == summary.failed && summary.ok + summary.skipped + summary.reused == 0;
  return nothing_but_data ? 3 : 1;
}

Config config_of(const RunArguments& arguments, const Source& source) {
  Config config = read_config(source.config, arguments.quick ? Size::quick : Size::full);
  if (!source.name.empty()) config.name = source.name;
  for (const std::string& setting : arguments.set) set_parameter(config, setting);
  if (!arguments.seeds.empty()) config.seeds = arguments.seeds;
  return config;
}

RunOptions options_of(const RunArguments& arguments, const CommonArguments& common) {
  RunOptions options;
  options.program = std::filesystem::read_symlink("/proc/self/exe");
  options.jobs = arguments.jobs;
  options.threads = common.threads;
  options.force = arguments.force;
  return options;
}

void say_stopped(const RunSummary& summary) {
  fmt::print(stderr, "isobench: stopped ({}); nothing is half-done, the same command continues from here\n",
             counts(summary));
}

// Some cells of a plan as it was frozen: what a task of a cluster does. The report is for when all are done.
int run_some(const RunArguments& arguments, const CommonArguments& common) {
  const bool more =
      arguments.only != "*" || arguments.out || !arguments.set.empty() || !arguments.seeds.empty() || arguments.quick;
  if (more || !std::filesystem::is_directory(arguments.config)) {
    throw UsageError(
        "--cells goes with a results folder alone, whose plan it takes as it is; freeze one by `isobench submit` or "
        "begin one by `isobench run`");
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
  if (summary.interrupted) {
    say_stopped(summary);
    return 130;
  }
  console.line(
      fmt::format("{}; the report, once all is done: isobench report {}", counts(summary), arguments.config.string()));
  return exit_code(summary);
}

}  // namespace

std::vector<RunRequest> read_plan(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "plan.json";
  if (!std::filesystem::exists(path))
    throw UsageError(folder.string() + " has no plan.json, so it is no results folder; give one, e.g. results/paper");
  return plan_from_json(read_text(path), path.string());
}

FrozenPlan freeze_plan(const RunArguments& arguments) {
  const Source source = source_of(arguments);
  const Config config = config_of(arguments, source);
  FrozenPlan frozen{source.out / config.name, make_plan(config)};
  const Store store(frozen.folder, config, frozen.plan);
  return frozen;
}

int run_verb(const RunArguments& arguments, const CommonArguments& common) {
  if (!arguments.cells.empty()) return run_some(arguments, common);
  const Source source = source_of(arguments);
  const Config config = config_of(arguments, source);
  const std::vector<RunRequest> plan = make_plan(config);
  const std::vector<RunRequest> cells = selection(plan, arguments.only);
  const std::filesystem::path folder = source.out / config.name;
  if (arguments.dry_run) {
    check_folder(folder, config);
    print_plan(folder, cells, arguments.force);
    return 0;
  }
  Console console(common.verbosity);
  const Store store(folder, config, plan);
  const RunSummary summary = run_cells(store, cells, options_of(arguments, common), console);
  if (summary.interrupted) {
    say_stopped(summary);
    return 130;
  }
  const Report report = make_report(folder, common, console);
  console.line(fmt::format("{}: {}", config.name, counts(summary)));
  if (common.verbosity != Verbosity::quiet) {
    fmt::print("{}", report.tables);
    std::fflush(stdout);  // what follows on stderr comes after it
    if (source.again_of) fmt::print("{}", what_differs(*source.again_of, folder));
  }
  say_written(folder, report, console);
  return exit_code(summary);
}

int report_verb(const std::filesystem::path& folder, const CommonArguments& common) {
  Console console(common.verbosity);
  const Report report = make_report(folder, common, console);
  if (common.verbosity != Verbosity::quiet) {
    fmt::print("{}", report.tables);
    std::fflush(stdout);
  }
  say_written(folder, report, console);
  return 0;
}

}  // namespace isobench
