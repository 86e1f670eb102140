// An experiment on a Slurm cluster comes out as it does on one machine, whatever happens to tasks and nodes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "experiments/test_cluster.h"
#include "reports/results.h"

namespace isobench {
namespace {

namespace fs = std::filesystem;

/// The records of a results folder by run, and no run twice.
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

/// experiments/quick.toml with several seeds, on those of its datasets that need no download.
std::string quick_experiment() {
  std::string text = text_of(fs::path(ISOBENCH_EXPERIMENTS) / "quick.toml");
  const auto replace_line = [&text](const std::string& start, const std::string& line) {
    const std::size_t at = text.find("\n" + start) + 1;
    text.replace(at, text.find('\n', at) - at, line);
  };
  replace_line("dataset = ", "dataset = [\"torus\", \"rounded-box\"]");
  replace_line("seed = ", "seed = [1, 2, 3]");
  return text;
}

class ClusterSlow : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string reason = no_cluster(); !reason.empty()) GTEST_SKIP() << "no cluster here: " << reason;
    cluster = std::make_unique<Cluster>();
    cluster->runs_in(folder.path().string());
    ASSERT_TRUE(cluster->ready());
  }
  Outcome call(const std::vector<std::string>& arguments) const { return run_program(folder.path(), arguments); }
  std::string status(const std::string& name) const { return call({"status", "results/" + name}).out; }

  TestFolder folder;
  std::unique_ptr<Cluster> cluster;
};

TEST_F(ClusterSlow, GivesWhatOneMachineGives) {
  folder.write("quick.toml", quick_experiment());
  const Outcome submitted = call({"submit", "quick.toml", "--chunk", "3", "--exclusive-timing"});
  ASSERT_EQ(submitted.code, 0) << submitted.err;
  EXPECT_NE(submitted.out.find("submitted 24 of 24 cells in 8 tasks"), std::string::npos) << submitted.out;
  const Outcome again = call({"submit", "quick.toml"});
  EXPECT_NE(again.out.find("nothing to submit"), std::string::npos) << again.out << again.err;
  const fs::path far = folder.path() / "results/quick";
  ASSERT_TRUE(eventually([&] { return fs::exists(far / "results.csv"); })) << status("quick");
  EXPECT_NE(status("quick").find("24 cells: 24 done\n"), std::string::npos) << status("quick");
  EXPECT_EQ(hosts(far), (std::set<std::string>{"n1", "n2"}));
  for (const auto& [run, record] : records(far)) {
    EXPECT_TRUE(record.environment.exclusive) << run;
    EXPECT_FALSE(record.environment.job.empty()) << run;
  }
  ASSERT_EQ(call({"run", "quick.toml", "--out", "local", "--quiet"}).code, 0);
  const Outcome same = call({"compare", "results/quick", "local/quick"});
  EXPECT_EQ(same.code, 0) << same.out;
  EXPECT_NE(same.out.find("24 runs are the same in both in all but seconds and memory"), std::string::npos) << same.out;
}

/// Ten cells; one of them never ends by itself, one takes memory without end.
TEST_F(ClusterSlow, LosesNothingWhenTasksAndNodesFail) {
  folder.write("faults.toml",
               "title = \"Faults\"\ndataset = [\"sphere\", \"torus\"]\nseed = [1, 2, 3, 4, 5]\n[sampling]\n"
               "edge_length = 4\n[[method]]\nname = \"particles\"\n[limits]\nminutes = 5\nmemory_gb = 1\n");
  const fs::path results = folder.path() / "results/faults";
  setenv("ISOBENCH_TEST_FAULT", "hang:sphere-particles-*-s2-*;memory:torus-particles-*-s3-*", 1);
  const Outcome submitted = call({"submit", "faults.toml", "--chunk", "1"});
  unsetenv("ISOBENCH_TEST_FAULT");
  ASSERT_EQ(submitted.code, 0) << submitted.err;
  // All but the one that hangs come to an end; that one is seen at work, with its task.
  ASSERT_TRUE(eventually([&] {
    return status("faults").find("8 done, 1 running, 1 out of memory") != std::string::npos;
  })) << status("faults");
  const std::string at_work = status("faults");
  const std::size_t job = at_work.find(", job ");
  ASSERT_NE(job, std::string::npos) << at_work;
  const std::string task = at_work.substr(job + 6, at_work.find(',', job + 6) - job - 6);
  run_command({"scancel", task});
  ASSERT_TRUE(Cluster::drained()) << run_command({"squeue"}).out;
  EXPECT_NE(status("faults").find("8 done, 1 out of memory, 1 missing"), std::string::npos) << status("faults");
  const auto before = records(results);

  // What is left goes to nodes of which one dies while it is at it.
  setenv("ISOBENCH_TEST_FAULT", "hang:sphere-particles-*-s2-*", 1);
  const Outcome second = call({"submit", "faults.toml"});
  unsetenv("ISOBENCH_TEST_FAULT");
  EXPECT_NE(second.out.find("submitted 2 of 10 cells"), std::string::npos) << second.out << second.err;
  ASSERT_TRUE(eventually([&] { return status("faults").find("1 running") != std::string::npos; })) << status("faults");
  const std::string where = status("faults");
  const std::string node = where.substr(where.find(" on n") + 4, 2);
  cluster->kill_node(node);
  run_command({"scancel", "--user=root"});  // Slurm itself would hand it to the other node, there to hang again
  cluster->start_node(node);
  ASSERT_TRUE(Cluster::drained()) << run_command({"squeue"}).out;
  EXPECT_EQ(status("faults").find("running"), std::string::npos) << status("faults");
  const Outcome third = call({"submit", "faults.toml"});
  EXPECT_EQ(third.code, 0) << third.err;
  ASSERT_TRUE(eventually([&] { return status("faults").find("10 done") != std::string::npos; })) << status("faults");
  // What was done stayed as it was.
  const auto after = records(results);
  ASSERT_EQ(after.size(), 10U);
  for (const auto& [run, record] : before) {
    if (record.status == Status::ok) {
      EXPECT_EQ(after.at(run).environment.job, record.environment.job) << run;
    }
  }
}

}  // namespace
}  // namespace isobench
