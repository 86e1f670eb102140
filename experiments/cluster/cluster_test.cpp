// An experiment on a Slurm cluster gives the results of one machine, whatever happens to tasks and nodes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "isobench/experiments/cluster/test_cluster.h"
#include "isobench/reports/runs/results.h"

namespace isobench {
namespace {

namespace fs = std::filesystem;

/// The records of a results folder by run.
std::map<std::string, RunRecord> records(const fs::path& folder) {
  std::map<std::string, RunRecord> all;
  for (RunRecord& record : load_results(folder).records) all[record.request.run] = std::move(record);
  return all;
}

std::set<std::string> hosts(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& [run, record] : records(folder)) names.insert(record.environment.host);
  return names;
}

// Far more than anything here takes on a busy machine.
constexpr std::chrono::minutes patience(10);

class OnACluster : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string reason = no_cluster(); !reason.empty()) GTEST_SKIP() << "no cluster here: " << reason;
    cluster = std::make_unique<Cluster>();
    cluster->runs_in(folder.path().string());
    ASSERT_TRUE(cluster->ready());
  }
  Outcome call(const std::vector<std::string>& arguments) const { return run_program(folder.path(), arguments); }

  TestFolder folder;
  std::unique_ptr<Cluster> cluster;
};

TEST_F(OnACluster, GivesWhatOneMachineGives) {
  const std::string config = std::string(ISOBENCH_EXPERIMENTS) + "/quick.toml";
  if (const Outcome data = call({"fetch", "skull-small", "brain-mni-half"}); data.code != 0)
    GTEST_SKIP() << "no data here: " << data.err;
  const Outcome submitted = call({"submit", config, "--seed", "1,2", "--chunk", "4", "--exclusive-timing"});
  ASSERT_EQ(submitted.code, 0) << submitted.err;
  EXPECT_NE(submitted.out.find("submitted 32 of 32 cells in 8 tasks"), std::string::npos) << submitted.out;
  const Outcome again = call({"submit", config, "--seed", "1,2"});
  EXPECT_NE(again.out.find("nothing to submit"), std::string::npos) << again.out << again.err;
  const fs::path far = folder.path() / "results/quick";
  ASSERT_TRUE(eventually([&] { return fs::exists(far / "results.csv"); }, patience))
      << call({"status", "results/quick"}).out;
  EXPECT_NE(call({"status", "results/quick"}).out.find("32 cells: 32 done\n"), std::string::npos);
  EXPECT_EQ(hosts(far), (std::set<std::string>{"n1", "n2"}));
  for (const auto& [run, record] : records(far)) {
    EXPECT_TRUE(record.environment.exclusive) << run;
    EXPECT_FALSE(record.environment.job.empty()) << run;
  }
  ASSERT_EQ(call({"run", config, "--seed", "1,2", "--out", "local", "--quiet"}).code, 0);
  const auto expected = figures(folder.path() / "local/quick");
  ASSERT_EQ(expected.size(), 33U);
  EXPECT_EQ(figures(far), expected);
  const Outcome same = call({"compare", "results/quick", "local/quick"});
  EXPECT_EQ(same.code, 0) << same.out;
  EXPECT_NE(same.out.find("32 runs are the same on both sides, except for seconds and memory"), std::string::npos)
      << same.out;
}

class OnAFailingCluster : public OnACluster {
 protected:
  fs::path results() const { return folder.path() / "results/faults"; }
  std::string status() const { return call({"status", "results/faults"}).out; }
  /// Waits until the verb `status` prints these words.
  void become(const std::string& words) const {
    EXPECT_TRUE(eventually([&] { return status().find(words) != std::string::npos; }, patience))
        << words << ": " << status();
  }
  /// Submits the cells that are not done, with these faults.
  void submit_with(const std::string& faults, const std::vector<std::string>& more, const std::string& words) const {
    std::vector<std::string> arguments = {"submit", "faults.toml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run_program(folder.path(), arguments, {{"ISOBENCH_TEST_FAULT", faults}});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find(words), std::string::npos) << outcome.out;
  }
  static std::string word_after(const std::string& text, const std::string& words) {
    const std::size_t at = text.find(words);
    if (at == std::string::npos) return "";
    const std::size_t start = at + words.size();
    return text.substr(start, text.find_first_of(",\n", start) - start);
  }
};

/// Of ten cells one never ends, one exceeds its limit of time and one its limit of memory.
TEST_F(OnAFailingCluster, LosesNothingWhenTasksAndNodesFail) {
  folder.write("faults.toml",
               "title = \"Faults\"\ndataset = [\"sphere\", \"torus\"]\nseed = [1, 2, 3, 4, 5]\n[sampling]\n"
               "edge_length = 4\n[[method]]\nname = \"particles\"\n[limits]\nminutes = 5\nmemory_gb = 1\n"
               "[[override]]\ndataset = \"torus\"\nlimits = { minutes = 0.5 }\n");
  submit_with("hang:*-s2-*;memory:sphere-particles-*-s3-*", {"--chunk", "1"}, "submitted 10 of 10 cells in 10 tasks");
  // All end except the sphere that hangs; `status` shows it running, with its task.
  become("7 done, 1 running, 1 timeout, 1 out of memory");
  run_command({"scancel", word_after(status(), ", job ")});
  ASSERT_TRUE(Cluster::drained()) << run_command({"squeue"}).out;
  become("7 done, 1 timeout, 1 out of memory, 1 missing");
  const auto before = records(results());

  // The limit of Slurm is the shorter one. Slurm first sends a signal, and the program drops its cell. Slurm checks
  // every half minute and may send the signal that much early: with a limit of one minute it could come while the
  // program starts.
  submit_with("hang:sphere-particles-*-s2-*", {"--chunk", "1", "--", "--time=2"}, "submitted 3 of 10 cells");
  ASSERT_TRUE(Cluster::drained()) << run_command({"squeue"}).out;
  EXPECT_EQ(count_starting(results(), "sphere-particles-l4-s2-"), 0U);
  const std::string log = read_text(results() / ".slurm/0002-0.log");
  EXPECT_NE(log.find("isobench: stopped ("), std::string::npos) << log;
  EXPECT_NE(status().find("missing"), std::string::npos) << status();

  // A node dies while it runs the task. Cancel the task: Slurm would start it on the other node, where it hangs again.
  submit_with("hang:sphere-particles-*-s2-*", {}, "submitted ");
  become("1 running");
  const std::string node = word_after(status(), " on ");
  cluster->kill_node(node);
  run_command({"scancel", "--user=root"});
  cluster->start_node(node);
  ASSERT_TRUE(Cluster::drained()) << run_command({"squeue"}).out;
  EXPECT_EQ(status().find("running"), std::string::npos) << status();
  submit_with("", {}, "submitted ");
  become("10 done");
  // Runs that were done before were not repeated.
  const auto after = records(results());
  ASSERT_EQ(after.size(), 10U);
  for (const auto& [run, record] : before) {
    if (record.status == Status::ok) {
      EXPECT_EQ(after.at(run).environment.job, record.environment.job) << run;
    }
  }
}

}  // namespace
}  // namespace isobench
