// Submits experiments to scripts that stand in for Slurm's commands, and divides work without Slurm.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <fstream>
#include <numeric>

#include "isobench/experiments/command_line/test_program.h"
#include "isobench/experiments/plan/config.h"
#include "isobench/experiments/plan/plan.h"
#include "isobench/experiments/runner/store.h"
#include "isobench/reports/record/sample_records.h"

namespace isobench {
namespace {

namespace fs = std::filesystem;

const char* const two_spheres =
    "title = \"Two\"\nmatch = \"vertices\"\nmatch_to = \"marching-cubes\"\ndataset = [\"sphere\"]\nseed = [1, 2, 3, 4, "
    "5, "
    "6]\n[sampling]\nedge_length = 6\n[[method]]\n"
    "name = \"marching-cubes\"\n[[method]]\nname = \"particles\"\n[limits]\nminutes = 3\nmemory_gb = 2\n";

/// Scripts in place of the commands of Slurm. sbatch logs its arguments and prints the number of a job.
class FakeSlurm {
 public:
  explicit FakeSlurm(const TestFolder& folder, int array_size = 3) : folder_(folder) {
    write("sbatch", "[ \"$1\" = --version ] && exit 0\necho \"$@\" >>$0.calls\necho $((100 + $(wc -l <$0.calls)))");
    write("scontrol", fmt::format("echo 'MaxArraySize            = {}'", array_size));
    write("squeue", "cat $0.queue 2>/dev/null || true");
  }
  std::map<std::string, std::string> environment() const {
    return {{"PATH", (folder_.path() / "bin").string() + ":" + std::getenv("PATH")}};
  }
  std::vector<std::string> calls() const {
    std::vector<std::string> lines;
    std::ifstream file(folder_.path() / "bin/sbatch.calls");
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
  }
  void queue(const std::string& text) const { folder_.write("bin/squeue.queue", text); }

 private:
  void write(const std::string& name, const std::string& body) const {
    folder_.write("bin/" + name, "#!/bin/sh\n" + body + "\n");
    fs::permissions(folder_.path() / "bin" / name, fs::perms::owner_all);
  }
  const TestFolder& folder_;
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Submit, WithoutSlurmSaysWhatWorksInstead) {
  TestFolder folder;
  folder.write("two.toml", two_spheres);
  const Outcome outcome = run_program(folder.path(), {"submit", "two.toml"}, {{"PATH", "/nowhere"}});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_TRUE(has(outcome.err, "no Slurm on this machine")) << outcome.err;
  EXPECT_TRUE(has(outcome.err, "isobench run --cells 1-12 ")) << outcome.err;
  // Follow its advice: run the cells in two parts, then make the report.
  for (const char* cells : {"1-6", "7-12"}) {
    const Outcome part = run_program(folder.path(), {"run", "--quiet", "--cells", cells, "results/two"});
    EXPECT_EQ(part.code, 0) << part.err;
    EXPECT_FALSE(fs::exists(folder.path() / "results/two/results.csv"));
  }
  EXPECT_TRUE(has(run_program(folder.path(), {"status", "results/two"}).out, "12 cells: 12 done"));
  EXPECT_EQ(run_program(folder.path(), {"report", "-q", "results/two"}).code, 0);
}

TEST(Submit, CutsIntoArraysThatTheClusterTakes) {
  TestFolder folder;
  const FakeSlurm slurm(folder);
  folder.write("two.toml", two_spheres);
  const auto submit = [&](std::vector<std::string> more = {}) {
    std::vector<std::string> words = {"submit", "two.toml", "--chunk", "2", "--throttle", "4"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(folder.path(), words, slurm.environment());
  };
  const Outcome outcome = submit({"--", "--partition=long"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  // Three tasks of two cells in two arrays, as an array may have two tasks; the same for the cells matched to them; a
  // report.
  const std::vector<std::string> calls = slurm.calls();
  ASSERT_EQ(calls.size(), 5U) << outcome.out;
  EXPECT_TRUE(has(calls[0], "--array=0-1%4")) << calls[0];
  EXPECT_TRUE(has(calls[0], "--time=10 --mem=2500M")) << calls[0];
  EXPECT_TRUE(has(calls[0], "--partition=long")) << calls[0];
  EXPECT_FALSE(has(calls[0], "--dependency")) << calls[0];
  EXPECT_TRUE(has(calls[1], "--array=0-0%4")) << calls[1];
  EXPECT_TRUE(has(calls[2], "--dependency=afterany:101:102")) << calls[2];
  EXPECT_TRUE(has(calls[4], "--dependency=afterany:101:102:103:104")) << calls[4];
  EXPECT_TRUE(has(outcome.out, "scancel 101 102 103 104 105")) << outcome.out;

  // Cells that wait in the queue are not submitted again. Cells that have left it without a record are.
  slurm.queue("101_0 PENDING\n101_1 PENDING\n102_0 RUNNING\n103_0 PENDING\n");
  const std::string state = run_program(folder.path(), {"status", "results/two"}, slurm.environment()).out;
  EXPECT_TRUE(has(state, "12 cells: 0 done, 8 waiting, 4 missing")) << state;
  EXPECT_TRUE(has(submit().out, "submitted 4 of 12 cells in 2 tasks")) << submit().out;
}

TEST(Submit, SaysWhatSbatchRefused) {
  TestFolder folder;
  const FakeSlurm slurm(folder);
  folder.write("bin/sbatch",
               "#!/bin/sh\n[ \"$1\" = --version ] && exit 0\necho 'sbatch: error: invalid partition' >&2\nexit 1\n");
  folder.write("two.toml", two_spheres);
  const Outcome outcome = run_program(folder.path(), {"submit", "two.toml"}, slurm.environment());
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(has(outcome.err, "sbatch refused: sbatch: error: invalid partition")) << outcome.err;
  EXPECT_TRUE(has(run_program(folder.path(), {"status", "results/two"}, slurm.environment()).out, "12 missing"));
}

/// A record as long as those of `particles`, which are the longest.
RunRecord full_record(const RunRequest& request) {
  RunRecord record = sample_record(request.dataset, request.method);
  record.request = request;
  record.environment.libraries =
      LibraryVersions{{"CGAL", "5.5.1"}, {"Eigen", "3.4.0"}, {"TBB", "2021.8.0"}, {"VTK", "9.1.0"}, {"fmt", "9.1.0"}};
  record.mesh_checksum = std::string(64, 'c');
  std::map<std::string, double> counters;
  for (int n = 0; n < 24; ++n) {
    counters[fmt::format("particles/counted number {}", n)] = n;
    record.stages.push_back({fmt::format("mesh/relaxation/step {}", n), 0.25, 0.5});
  }
  record.counters = counters;
  record.traces = {{"energy", std::vector<double>(40, 0.75)}, {"particles", std::vector<double>(4, 17.0)}};
  return record;
}

/// A plan may have 100,000 cells, and the program may then take 1 GB: less than half of it for the plan, nine tenths
/// with all records. This test has a twentieth of the cells. It allows a twentieth of the memory, and what the program
/// and its libraries take by themselves.
TEST(Submit, StaysSmallForVeryManyCells) {
  constexpr double most_of_plan_mb = 20.0 + 35.0;
  constexpr double most_of_records_mb = 45.0 + 55.0;
  TestFolder folder;
  const FakeSlurm slurm(folder, 1001);
  std::vector<int> seeds(250);
  std::iota(seeds.begin(), seeds.end(), 1);
  folder.write("wide.toml", fmt::format("dataset = [\"sphere\", \"torus\"]\nseed = [{}]\n[sampling]\nepsilon = [0.3, "
                                        "0.4, 0.5, 0.6, 0.7]\ndelta = [0.2, 0.3]\n[[method]]\nname = "
                                        "\"particles\"\n[limits]\nminutes = 1\n",
                                        fmt::join(seeds, ", ")));
  const auto call = [&](const std::vector<std::string>& words, double most_mb) {
    std::map<std::string, std::string> environment = slurm.environment();
    environment["ISOBENCH_TABLES_ONLY"] = "false";
    Outcome outcome = run_program(folder.path(), words, environment);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_LT(outcome.peak_memory_mb, most_mb) << words.front();
    return outcome;
  };
  EXPECT_TRUE(
      has(call({"submit", "wide.toml"}, most_of_plan_mb).out, "submitted 5000 of 5000 cells in 1000 tasks: job 101;"));
  std::string queue;
  for (int task = 0; task < 1000; ++task) queue += fmt::format("101_{} PENDING\n", task);
  slurm.queue(queue);
  EXPECT_TRUE(has(call({"status", "results/wide"}, most_of_plan_mb).out, "5000 cells: 0 done, 5000 waiting"));
  // Write what finished runs leave, instead of running them.
  const fs::path results = folder.path() / "results/wide";
  const std::vector<RunRequest> plan = plan_from_json(read_text(results / "plan.json"), "plan.json");
  tbb::parallel_for(std::size_t{0}, plan.size(), [&](std::size_t n) {
    fs::create_directory(results / plan[n].run);
    write_record(full_record(plan[n]), results / plan[n].run / "run.json");
  });
  EXPECT_TRUE(has(call({"status", "results/wide"}, most_of_plan_mb).out, "5000 cells: 5000 done"));
  call({"report", "--quiet", "results/wide"}, most_of_records_mb);
  EXPECT_EQ(figures(results).size(), plan.size() + 1);
  EXPECT_LT(fs::file_size(results / "report.html"), 10000000U);
}

TEST(Cells, NeedAFrozenPlan) {
  TestFolder folder;
  folder.write("two.toml", two_spheres);
  const Outcome config = run_program(folder.path(), {"run", "--cells", "1", "two.toml"});
  EXPECT_EQ(config.code, 2);
  EXPECT_TRUE(has(config.err, "--cells goes with a results folder")) << config.err;
  EXPECT_TRUE(has(run_program(folder.path(), {"status", "results/two"}).err, "no plan.json"));
}

/// Claims, records and commits every run of a plan in this process, without meshing.
void do_all(const Store& store, const std::vector<RunRequest>& cells, const fs::path& log) {
  std::ofstream done(log);
  for (const RunRequest& request : cells) {
    if (store.state(request) == RunState::done) continue;
    std::optional<Claim> claim = store.claim(request);
    if (!claim || store.state(request) == RunState::done) continue;
    RunRecord record;
    record.request = request;
    record.status = Status::skipped;
    record.reason = "a stand-in";
    write_record(record, claim->folder() / "run.json");
    claim->commit();
    done << request.run << '\n';
  }
}

TEST(Cells, RacingProcessesDoEachOnceAndLoseNone) {
  TestFolder folder;
  std::string seeds;
  for (int seed = 1; seed <= 1000; ++seed) seeds += fmt::format("{}{}", seed > 1 ? ", " : "", seed);
  folder.write("race.toml", "title = \"Race\"\ndataset = [\"sphere\"]\nseed = [" + seeds +
                                "]\n[sampling]\nedge_length = 6\n[[method]]\nname = \"marching-cubes\"\n");
  const Config config = read_config(folder.path() / "race.toml");
  const std::vector<RunRequest> plan = make_plan(config);
  ASSERT_EQ(plan.size(), 1000U);
  constexpr int rounds = 3;  // each round writes a thousand records
  for (int round = 0; round < rounds; ++round) {
    const fs::path results = folder.path() / fmt::format("round-{}", round);
    const Store store(results, config, plan);
    std::vector<pid_t> racers;
    for (int racer = 0; racer < 2; ++racer) {
      racers.push_back(fork());
      if (racers.back() != 0) continue;
      do_all(store, plan, results / fmt::format("done-{}", racer));
      _exit(0);
    }
    for (const pid_t racer : racers) {
      int status = 0;
      waitpid(racer, &status, 0);
      ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    }
    std::map<std::string, int> times;
    for (int racer = 0; racer < 2; ++racer) {
      std::ifstream done(results / fmt::format("done-{}", racer));
      for (std::string run; done >> run;) ++times[run];
    }
    ASSERT_EQ(times.size(), 1000U);
    for (const auto& [run, count] : times) ASSERT_EQ(count, 1) << run;
    for (const RunRequest& request : plan) ASSERT_EQ(store.state(request), RunState::done) << request.run;
    fs::remove_all(results);
  }
}

}  // namespace
}  // namespace isobench
