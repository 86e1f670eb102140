#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "isobench/experiments/cluster/slurm.h"
#include "isobench/experiments/cluster/submission.h"
#include "isobench/experiments/command_line/frozen_plan.h"
#include "isobench/experiments/command_line/verbs.h"
#include "isobench/experiments/plan/cell_numbers.h"
#include "isobench/experiments/plan/plan.h"
#include "isobench/reports/runs/results.h"
#include "isobench/reports/runs/spread.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

using Numbers = std::vector<std::size_t>;

// Long enough that the time Slurm takes to start a task does not matter.
constexpr double minutes_per_task = 5.0;
// As long as no cell is done, it is not known how long cells take. There are then at most this many tasks.
constexpr std::size_t most_tasks_of_unknown_length = 1000;

// A text as one word for a shell.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
  return result + "'";
}

// Numbers of the cells that are missing or failed: neither done, nor running, nor waiting in a queue.
Numbers cells_to_do(const FolderState& state) {
  Numbers numbers;
  for (std::size_t n = 0; n < state.cells.size(); ++n) {
    const Whereabouts where = state.cells[n].where;
    if (where != Whereabouts::done && where != Whereabouts::running && where != Whereabouts::waiting)
      numbers.push_back(n + 1);
  }
  return numbers;
}

// Median seconds of the cells that are done; std::nullopt while there are none.
std::optional<double> median_seconds(const fs::path& folder, const std::vector<RunRequest>& plan,
                                     const FolderState& state) {
  constexpr std::size_t enough = 200;  // for a median
  std::vector<double> seconds;
  for (std::size_t n = 0; n < plan.size() && seconds.size() < enough; ++n) {
    if (state.cells[n].where != Whereabouts::done) continue;
    const RunRecord record = read_record(folder / plan[n].run / "run.json");
    double all = 0.0;
    for (const StageTime& stage : record.stages) {
      if (stage.name.find('/') == std::string::npos) all += stage.wall_seconds;
    }
    seconds.push_back(all);
  }
  if (seconds.empty()) return std::nullopt;
  return spread_of(std::move(seconds)).median;
}

class Submitter {
 public:
  Submitter(const SubmitArguments& arguments, const CommonArguments& common, fs::path folder,
            const std::vector<RunRequest>& plan)
      : arguments_(arguments), common_(common), folder_(std::move(folder)), plan_(plan) {}

  int run() {
    const std::optional<FileLock> lock = FileLock::try_lock(folder_ / ".locks" / "submit");
    if (!lock) throw Error(folder_.string() + ": another `isobench submit` is submitting it; try again later");
    const FolderState state = folder_state(folder_, plan_);
    if (!state.queue_known)
      throw Error("squeue does not answer, and cells that wait in its queue would be submitted twice; try again later");
    const Numbers to_do = cells_to_do(state);
    if (to_do.empty()) {
      fmt::print("nothing to submit: none of {} cells is missing or failed; see isobench status {}\n", plan_.size(),
                 folder_.string());
      return 0;
    }
    fs::create_directories(slurm_folder(folder_));
    chunk_ = arguments_.chunk.value_or(chunk_for(to_do.size(), median_seconds(folder_, plan_, state)));
    // Cells that are matched to another run start after it.
    Numbers first;
    Numbers second;
    for (const std::size_t number : to_do) (plan_[number - 1].match_to.empty() ? first : second).push_back(number);
    submit_arrays(first, "");
    submit_arrays(second, first.empty() ? "" : "afterany:" + fmt::format("{}", fmt::join(jobs_, ":")));
    const std::string report = submit_report();
    print_jobs(to_do.size(), report);
    return 0;
  }

 private:
  std::size_t chunk_for(std::size_t cells, const std::optional<double>& seconds) const {
    if (seconds) return std::max(std::size_t{1}, static_cast<std::size_t>(60.0 * minutes_per_task / (*seconds + 0.5)));
    return (cells + most_tasks_of_unknown_length - 1) / most_tasks_of_unknown_length;
  }

  void submit_arrays(const Numbers& cells, const std::string& after) {
    const std::size_t most = most_tasks();
    for (std::size_t start = 0; start < cells.size(); start += most * chunk_) {
      const std::size_t end = std::min(cells.size(), start + most * chunk_);
      submit_array(
          Numbers(cells.begin() + static_cast<std::ptrdiff_t>(start), cells.begin() + static_cast<std::ptrdiff_t>(end)),
          after);
    }
  }

  void submit_array(const Numbers& cells, const std::string& after) {
    const fs::path base = next_base();
    std::string list;
    std::size_t tasks = 0;
    for (std::size_t start = 0; start < cells.size(); start += chunk_, ++tasks) {
      const std::size_t end = std::min(cells.size(), start + chunk_);
      list += cell_numbers_text(Numbers(cells.begin() + static_cast<std::ptrdiff_t>(start),
                                        cells.begin() + static_cast<std::ptrdiff_t>(end))) +
              "\n";
    }
    write_text(fs::path(base).concat(".tasks"), list);
    write_text(fs::path(base).concat(".sh"), script(fs::path(base).concat(".tasks")));
    const std::string throttle = arguments_.throttle ? fmt::format("%{}", *arguments_.throttle) : "";
    std::vector<std::string> words = {"--job-name=isobench-" + folder_.filename().string(),
                                      fmt::format("--array=0-{}{}", tasks - 1, throttle),
                                      "--output=" + fs::path(base).concat("-%a.log").string()};
    if (!after.empty()) words.push_back("--dependency=" + after);
    const std::vector<std::string> limits = limit_words(cells);
    words.insert(words.end(), limits.begin(), limits.end());
    words.insert(words.end(), arguments_.sbatch.begin(), arguments_.sbatch.end());
    words.push_back(fs::path(base).concat(".sh").string());
    const std::string job = submit_batch(words);
    write_text(fs::path(base).concat(".job"), job + "\n");
    jobs_.push_back(job);
    tasks_ += tasks;
  }

  // Time and memory for a task, from the limits of its cells. The margins let isobench stop a run at its own limit, and
  // record that, before Slurm ends the task.
  std::vector<std::string> limit_words(const Numbers& cells) const {
    double minutes = 0.0;
    double memory_gb = 0.0;
    bool all_timed = true;
    bool all_bounded = true;
    for (const std::size_t number : cells) {
      const RunRequest& request = plan_[number - 1];
      minutes = std::max(minutes, request.limit_minutes.value_or(0.0));
      memory_gb = std::max(memory_gb, request.limit_memory_gb.value_or(0.0));
      all_timed = all_timed && request.limit_minutes.has_value();
      all_bounded = all_bounded && request.limit_memory_gb.has_value();
    }
    std::vector<std::string> words;
    const auto chunk = static_cast<double>(std::min(chunk_, cells.size()));
    // Each cell at its limit and a minute to start it; two more for an orderly end after the warning signal.
    if (all_timed) words.push_back(fmt::format("--time={}", std::lround(std::ceil(chunk * (minutes + 1.0) + 2.0))));
    if (all_bounded) words.push_back(fmt::format("--mem={}M", std::lround(std::ceil(memory_gb * 1000.0 + 500.0))));
    words.emplace_back("--signal=B:TERM@30");
    if (arguments_.exclusive) words.emplace_back("--exclusive");
    if (common_.threads > 0) words.push_back(fmt::format("--cpus-per-task={}", common_.threads));
    return words;
  }

  static std::string program() { return fs::read_symlink("/proc/self/exe").string(); }

  std::string script(const fs::path& tasks) const {
    const std::string threads = arguments_.exclusive ? "${SLURM_CPUS_ON_NODE:-0}" : "${SLURM_CPUS_PER_TASK:-1}";
    return fmt::format(
        "#!/bin/bash\n"
        "# A task of a job array: it runs the cells that its line of the list names.\n"
        "{}cells=$(sed -n \"$((SLURM_ARRAY_TASK_ID + 1))p\" {})\n"
        "exec {} run --quiet --threads \"{}\" --cells \"$cells\" {}\n",
        arguments_.exclusive ? "export ISOBENCH_EXCLUSIVE=1\n" : "", quoted(tasks.string()), quoted(program()), threads,
        quoted(folder_.string()));
  }

  std::string submit_report() const {
    const fs::path file = slurm_folder(folder_) / "report.sh";
    write_text(file,
               fmt::format("#!/bin/bash\nexec {} report --quiet {}\n", quoted(program()), quoted(folder_.string())));
    std::vector<std::string> words = {"--job-name=isobench-report",
                                      "--output=" + (slurm_folder(folder_) / "report.log").string(),
                                      fmt::format("--dependency=afterany:{}", fmt::join(jobs_, ":"))};
    words.insert(words.end(), arguments_.sbatch.begin(), arguments_.sbatch.end());
    words.push_back(file.string());
    return submit_batch(words);
  }

  fs::path next_base() const {
    for (int number = 1;; ++number) {
      fs::path base = slurm_folder(folder_) / fmt::format("{:04}", number);
      if (!fs::exists(fs::path(base).concat(".tasks"))) return base;
    }
  }

  void print_jobs(std::size_t cells, const std::string& report) const {
    fmt::print("submitted {} of {} cells in {} tasks: job{} {}; job {} writes the report\n", cells, plan_.size(),
               tasks_, jobs_.size() > 1 ? "s" : "", fmt::join(jobs_, ", "), report);
    fmt::print("watch:   isobench status {}\n", folder_.string());
    fmt::print("cancel:  scancel {} {}\n", fmt::join(jobs_, " "), report);
  }

  const SubmitArguments& arguments_;
  const CommonArguments& common_;
  fs::path folder_;
  const std::vector<RunRequest>& plan_;
  std::size_t chunk_ = 1;
  std::size_t tasks_ = 0;
  std::vector<std::string> jobs_;
};

}  // namespace

int submit_verb(const SubmitArguments& arguments, const CommonArguments& common) {
  const FrozenPlan frozen = freeze_plan(arguments.run);
  const fs::path folder = fs::canonical(frozen.folder);
  if (!has_slurm()) {
    throw UsageError(fmt::format(
        "there is no Slurm on this machine (sbatch does not work); the plan of {1} cells is in {0}: run it here by "
        "`isobench run {0}`, or run parts of it on machines that share the folder by `isobench run --cells 1-{1} {0}`, "
        "and at the end `isobench report {0}`",
        folder.string(), frozen.plan.size()));
  }
  return Submitter(arguments, common, folder, frozen.plan).run();
}

}  // namespace isobench
