// An experiment that is killed and continued, or done by several processes, ends with the results of one plain run.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <numeric>
#include <random>
#include <set>
#include <thread>

#include "isobench/experiments/command_line/test_program.h"

namespace isobench {
namespace {

namespace fs = std::filesystem;

/// Writes an experiment of many cells that take a few milliseconds each. One of its methods depends on the seed.
void write_many(const TestFolder& folder, int seeds) {
  for (const char* name : {"sphere", "slab", "capsule"}) {
    folder.write(fmt::format("small-{}.toml", name),
                 fmt::format("title = \"Small\"\n[phantom]\nname = \"{}\"\nnodes = 24\n", name));
  }
  std::vector<int> numbers(static_cast<std::size_t>(seeds));
  std::iota(numbers.begin(), numbers.end(), 1);
  folder.write("many.toml", fmt::format("dataset = [\"small-sphere\", \"small-slab\", \"small-capsule\"]\n"
                                        "seed = [{}]\n[sampling]\nedge_length = 5\n[[method]]\nname = \"particles\"\n"
                                        "[[method]]\nname = \"marching-cubes\"\n",
                                        fmt::join(numbers, ", ")));
}

/// Tells where the manifests of the small lattices are, so that they have the same names in every working folder.
std::map<std::string, std::string> catalogue_in(const TestFolder& folder) {
  return {{"ISOBENCH_CATALOGUE", folder.path().string()}};
}

/// Every path in a folder, relative to it.
std::set<std::string> listing(const fs::path& folder) {
  std::set<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) paths.insert(fs::relative(entry, folder).string());
  return paths;
}

/// An experiment that ran to its end without a disturbance, in a folder of its own.
struct Undisturbed {
  TestFolder folder;
  double seconds = 0.0;
  std::size_t cells = 0;

  explicit Undisturbed(int seeds) : cells(static_cast<std::size_t>(6 * seeds)) {
    write_many(folder, seeds);
    const auto start = std::chrono::steady_clock::now();
    const Outcome outcome = run_program(folder.path(), {"run", "many.toml", "--threads", "1"}, catalogue_in(folder));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  fs::path results() const { return folder.path() / "results" / "many"; }
};

void expect_as_undisturbed(const fs::path& results, const Undisturbed& reference) {
  const auto expected = figures(reference.results());
  ASSERT_EQ(expected.size(), reference.cells + 1);
  const auto found = figures(results);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t row = 0; row < expected.size(); ++row) EXPECT_EQ(found[row], expected[row]) << "row " << row;
  // Nothing unfinished is left.
  EXPECT_EQ(listing(results), listing(reference.results()));
}

const std::vector<std::string> run_many = {"run", "many.toml", "--threads", "1"};

void expect_finished(const TestFolder& folder, const std::vector<std::string>& arguments) {
  const Outcome outcome = run_program(folder.path(), arguments, catalogue_in(folder));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
}

/// Starts the experiment and kills it at a random moment, several times. Returns how often it was killed before its
/// end.
int kill_at_random(const TestFolder& folder, int times, double longest, const std::vector<std::string>& arguments,
                   std::mt19937_64& random) {
  std::uniform_real_distribution<double> moment(0.0, longest);
  int alive = 0;
  for (int n = 0; n < times; ++n) {
    Program program(folder.path(), arguments, catalogue_in(folder));
    std::this_thread::sleep_for(std::chrono::duration<double>(moment(random)));
    program.signal(SIGKILL);
    alive += program.wait().signal == SIGKILL ? 1 : 0;
  }
  return alive;
}

TEST(Interruption, FiftySigkillsLeaveTheSameResults) {
  const Undisturbed reference(20);
  const TestFolder folder;
  write_many(folder, 20);
  const fs::path results = folder.path() / "results" / "many";
  std::mt19937_64 random(1);
  // On average each start lasts a seventieth of the whole, so that the experiment is not complete before the last one.
  const double longest = 2.0 * reference.seconds / 70.0;
  EXPECT_GE(kill_at_random(folder, 50, longest, run_many, random), 45) << "killed too late to disturb anything";
  expect_finished(folder, run_many);
  expect_as_undisturbed(results, reference);
  // The same while stored runs are being replaced.
  EXPECT_GE(kill_at_random(folder, 10, longest, with(run_many, {"--force", "--jobs", "2"}), random), 9);
  expect_finished(folder, run_many);
  expect_as_undisturbed(results, reference);
  EXPECT_TRUE(eventually([&] { return !process_mentions(folder.path().string()); })) << "a child outlived its parent";
}

/// How many cells a process ran, from the last line of its summary: "many: 5 ok, 2 done before".
int cells_done(const Outcome& outcome) {
  const std::string head = "many: ";
  const std::size_t at = outcome.err.rfind(head);
  EXPECT_NE(at, std::string::npos) << outcome.err;
  return at == std::string::npos ? 0 : std::stoi(outcome.err.substr(at + head.size()));
}

/// Processes that share one results folder. Each has its own working folder.
class Team {
 public:
  Team(const TestFolder& folder, std::size_t size, const std::string& fault = "") {
    std::map<std::string, std::string> environment = catalogue_in(folder);
    if (!fault.empty()) environment["ISOBENCH_TEST_FAULT"] = fault;
    const std::vector<std::string> arguments = {
        "run", (folder.path() / "many.toml").string(), "--out", (folder.path() / "results").string(), "--threads", "1"};
    for (std::size_t n = 0; n < size; ++n) {
      places_.push_back(std::make_unique<TestFolder>());
      programs_.emplace_back(places_.back()->path(), arguments, environment);
    }
  }
  Program& operator[](std::size_t n) { return programs_[n]; }
  std::size_t size() const { return programs_.size(); }

 private:
  std::vector<std::unique_ptr<TestFolder>> places_;
  std::vector<Program> programs_;
};

TEST(Interruption, ProcessesOnOneFolderDoEveryCellOnce) {
  const Undisturbed reference(10);
  for (const std::size_t size : {2U, 4U}) {
    const TestFolder folder;
    write_many(folder, 10);
    Team team(folder, size);
    std::vector<int> shares;
    for (std::size_t n = 0; n < size; ++n) {
      const Outcome outcome = team[n].wait();
      EXPECT_EQ(outcome.code, 0) << outcome.err;
      shares.push_back(cells_done(outcome));
    }
    EXPECT_EQ(std::accumulate(shares.begin(), shares.end(), 0), static_cast<int>(reference.cells));
    EXPECT_GT(*std::min_element(shares.begin(), shares.end()), 0) << "they did not run at the same time";
    expect_as_undisturbed(folder.path() / "results" / "many", reference);
  }
}

// The process that survives completes the tables; nobody has to start the experiment again.
TEST(Interruption, ASurvivorDoesWhatTheOthersLeft) {
  const Undisturbed reference(10);
  std::mt19937_64 random(2);
  for (int repeat = 0; repeat < 4; ++repeat) {
    const TestFolder folder;
    write_many(folder, 10);
    const fs::path results = folder.path() / "results" / "many";
    Team team(folder, 3);
    std::size_t done = 0;
    for (const std::size_t victim : {0U, 2U}) {
      done += std::uniform_int_distribution<std::size_t>(1, 20)(random);
      EXPECT_TRUE(eventually([&] { return fs::exists(results) && count_starting(results, "small-") >= done; }));
      team[victim].signal(SIGKILL);
      EXPECT_EQ(team[victim].wait().signal, SIGKILL);
    }
    const Outcome survivor = team[1].wait();
    EXPECT_EQ(survivor.code, 0) << survivor.err;
    EXPECT_EQ(figures(results), figures(reference.results()));
    // The next process removes what the killed ones began.
    expect_finished(folder, run_many);
    expect_as_undisturbed(results, reference);
  }
}

TEST(Interruption, AFailureIsNotRepeatedByAProcessThatWasThereBefore) {
  const TestFolder folder;
  write_many(folder, 1);
  const std::string held = (folder.path() / "results" / "many" / ".tmp-small-sphere-particles").string();
  Team early(folder, 1, "hang:small-sphere/particles");
  EXPECT_TRUE(eventually([&] { return process_mentions(held); }));
  Team late(folder, 1, "crash:*/marching-cubes");
  const Outcome failed = late[0].wait();
  EXPECT_NE(failed.err.find("many: 2 ok, 3 failed, 1 left to another process"), std::string::npos) << failed.err;
  for (const int child : processes_mentioning(held)) kill(child, SIGKILL);
  const Outcome waited = early[0].wait();
  EXPECT_NE(waited.err.find("many: 0 ok, 1 failed, 2 done before, 3 left to another process"), std::string::npos)
      << waited.err;
  // A process that starts later tries again.
  const Outcome later = run_program(folder.path(), run_many, catalogue_in(folder));
  EXPECT_NE(later.err.find("many: 4 ok, 2 done before"), std::string::npos) << later.err;
}

TEST(Interruption, DeathBeforeTheConfigIsWrittenIsNoObstacle) {
  const TestFolder folder;
  write_many(folder, 1);
  folder.write("results/many/.locks/store", "");
  folder.write("results/many/plan.json", "[]");
  folder.write("results/many/config.toml.tmp-4711", "data");
  folder.write("results/many/results.csv.tmp-4711", "run,");
  const Outcome refused = run_program(folder.path(), run_many, catalogue_in(folder));
  EXPECT_EQ(refused.code, 2) << "only what a start leaves may be there";
  fs::remove(folder.path() / "results/many/results.csv.tmp-4711");
  expect_finished(folder, run_many);
  folder.write("results/many/results.csv.tmp-4711", "run,");
  expect_finished(folder, run_many);
  for (const std::string& path : listing(folder.path() / "results" / "many")) {
    EXPECT_EQ(path.find(".tmp-"), std::string::npos) << path;
  }
}

}  // namespace
}  // namespace isobench
