// The runner as users see it: these tests run the program, kill it or make it crash, and look at what it leaves behind.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "isobench/experiments/command_line/test_program.h"

namespace isobench {
namespace {

namespace fs = std::filesystem;

const char* const two_datasets = R"(dataset = ["sphere", "slab"]
[sampling]
epsilon = 1.0
delta = 0.5
[[method]]
name = "marching-cubes"
)";

TEST(Runner, LeavesArtefactsWhereTheConfigAsks) {
  const TestFolder folder;
  const std::string config = R"(dataset = "sphere"
[sampling]
epsilon = 1.0
delta = 0.5
[[method]]
name = "particles"
)";
  folder.write("without.toml", config);
  folder.write("with.toml", std::string("artefacts = true\n").append(config));
  for (const char* name : {"without", "with"}) {
    const Outcome outcome = run_program(folder.path(), {"run", std::string(name) + ".toml"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const fs::path run = run_folder(folder.path() / "results" / name, "sphere-particles-");
    for (const char* artefact : {"medial-axis.vtp", "sizing.vtp", "particles.vtp"}) {
      EXPECT_EQ(fs::exists(run / artefact), std::string(name) == "with") << artefact;
    }
  }
}

TEST(Runner, StoresWholeRunsAndDoesThemOnce) {
  const TestFolder folder;
  folder.write("two.toml", two_datasets);
  const Outcome first = run_program(folder.path(), {"run", "two.toml"});
  ASSERT_EQ(first.code, 0) << first.err;
  const fs::path results = folder.path() / "results" / "two";
  for (const char* name : {"config.toml", "plan.json", "results.csv", "tables.md"}) {
    EXPECT_TRUE(fs::exists(results / name)) << name;
  }
  const fs::path run = run_folder(results, "sphere-marching-cubes-e1-d0.5-s1-");
  for (const char* name : {"run.json", "mesh.vtp", "log.txt"}) EXPECT_TRUE(fs::exists(run / name)) << name;
  const RunRecord record = read_record(run / "run.json");
  EXPECT_EQ(record.status, Status::ok);
  EXPECT_EQ(record.request.run, run.filename());
  EXPECT_EQ(record.measurement->number("euler"), 2);
  EXPECT_GT(record.peak_memory_mb, 1.0);
  EXPECT_GT(record.seconds_total, 0.0);
  EXPECT_NE(first.out.find("| sphere"), std::string::npos);

  const auto written = fs::last_write_time(run / "run.json");
  const Outcome second = run_program(folder.path(), {"run", "two.toml"});
  EXPECT_EQ(second.code, 0);
  EXPECT_NE(second.err.find("2 done before"), std::string::npos) << second.err;
  EXPECT_EQ(fs::last_write_time(run / "run.json"), written);
  EXPECT_EQ(run_program(folder.path(), {"run", "two.toml", "--force", "--only", "sphere/*"}).code, 0);
  EXPECT_NE(fs::last_write_time(run / "run.json"), written);
  EXPECT_EQ(count_starting(results, ".old-") + count_starting(results, ".tmp-"), 0U);
}

TEST(Runner, ACrashIsAFailedRowAndTheOthersFinish) {
  const TestFolder folder;
  folder.write("two.toml", two_datasets);
  const Outcome outcome = run_program(folder.path(), {"run", "two.toml"}, {{"ISOBENCH_TEST_FAULT", "crash:sphere/*"}});
  EXPECT_EQ(outcome.code, 1);
  const fs::path results = folder.path() / "results" / "two";
  const RunRecord crashed = record_of(results, "sphere");
  EXPECT_EQ(crashed.status, Status::failed);
  EXPECT_NE(crashed.reason.find("SIGSEGV"), std::string::npos) << crashed.reason;
  EXPECT_EQ(record_of(results, "slab").status, Status::ok);
  EXPECT_NE(read_text(results / "tables.md").find("failed: ended by SIGSEGV"), std::string::npos);
  EXPECT_NE(read_text(results / "results.csv").find(",failed,"), std::string::npos);
  // Failed runs are repeated, runs that are done are not.
  const Outcome again = run_program(folder.path(), {"run", "two.toml"});
  EXPECT_EQ(again.code, 0);
  EXPECT_NE(again.err.find("1 ok, 1 done before"), std::string::npos) << again.err;
  EXPECT_EQ(record_of(results, "sphere").status, Status::ok);
}

TEST(Runner, LimitsStopHangsAndMemoryHogs) {
  const TestFolder folder;
  folder.write("two.toml", std::string(two_datasets) + "[limits]\nminutes = 0.02\nmemory_gb = 0.5\n");
  const Outcome hang =
      run_program(folder.path(), {"run", "two.toml", "--only", "sphere/*"}, {{"ISOBENCH_TEST_FAULT", "hang:sphere/*"}});
  EXPECT_EQ(hang.code, 1);
  const fs::path results = folder.path() / "results" / "two";
  EXPECT_EQ(record_of(results, "sphere").status, Status::timeout);
  EXPECT_EQ(record_of(results, "sphere").reason, "not finished after 0.02 minutes");
  // In a folder of its own, so that the limit of time cannot be exceeded first.
  folder.write("hog.toml", std::string(two_datasets) + "[limits]\nminutes = 5\nmemory_gb = 0.5\n");
  const Outcome hog =
      run_program(folder.path(), {"run", "hog.toml", "--only", "slab/*"}, {{"ISOBENCH_TEST_FAULT", "memory:slab/*"}});
  EXPECT_EQ(hog.code, 1);
  const RunRecord starved = record_of(folder.path() / "results" / "hog", "slab");
  EXPECT_EQ(starved.status, Status::out_of_memory);
  EXPECT_EQ(starved.reason, "needed more than 0.5 GB");
}

TEST(Runner, AfterSigkillItContinuesWithNothingHalfDone) {
  const TestFolder folder;
  folder.write("two.toml", two_datasets);
  const fs::path results = folder.path() / "results" / "two";
  // The first run finishes and the second one hangs. Then kill the program.
  Program program(folder.path(), {"run", "two.toml", "--out", (folder.path() / "results").string()},
                  {{"ISOBENCH_TEST_FAULT", "hang:slab/*"}});
  const std::string cell = (results / ".tmp-slab").string();
  EXPECT_TRUE(eventually([&] { return fs::exists(results) && count_starting(results, ".tmp-slab") == 1; }));
  EXPECT_TRUE(eventually([&] { return process_mentions(cell); }));
  program.signal(SIGKILL);
  EXPECT_EQ(program.wait().signal, SIGKILL);
  // The child dies with its parent.
  EXPECT_TRUE(eventually([&] { return !process_mentions(cell); }));
  EXPECT_EQ(record_of(results, "sphere").status, Status::ok);
  EXPECT_EQ(count_starting(results, "slab"), 0U);
  const auto written = fs::last_write_time(run_folder(results, "sphere") / "run.json");

  const Outcome again = run_program(folder.path(), {"run", "two.toml"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_NE(again.err.find("1 ok, 1 done before"), std::string::npos) << again.err;
  EXPECT_EQ(fs::last_write_time(run_folder(results, "sphere") / "run.json"), written);
  EXPECT_EQ(record_of(results, "slab").status, Status::ok);
  EXPECT_EQ(count_starting(results, ".tmp-"), 0U);
}

TEST(Runner, SigintStopsCleanlyAndSaysHowToContinue) {
  const TestFolder folder;
  folder.write("two.toml", two_datasets);
  const fs::path results = folder.path() / "results" / "two";
  Program program(folder.path(), {"run", "two.toml"}, {{"ISOBENCH_TEST_FAULT", "hang:slab/*"}});
  EXPECT_TRUE(eventually([&] { return fs::exists(results) && count_starting(results, ".tmp-slab") == 1; }));
  program.signal(SIGINT);
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.code, 130);
  EXPECT_NE(outcome.err.find("continues from here"), std::string::npos) << outcome.err;
  EXPECT_EQ(count_starting(results, ".tmp-"), 0U);
  EXPECT_EQ(count_starting(results, "slab"), 0U);
  EXPECT_EQ(count_starting(results, "sphere"), 1U);
}

TEST(Runner, TwoProcessesOnOneFolderShareTheWork) {
  const TestFolder folder;
  folder.write("two.toml", two_datasets);
  const fs::path results = folder.path() / "results" / "two";
  Program holder(folder.path(), {"run", "two.toml", "--only", "sphere/*"}, {{"ISOBENCH_TEST_FAULT", "hang:sphere/*"}});
  EXPECT_TRUE(eventually([&] { return fs::exists(results) && count_starting(results, ".tmp-sphere") == 1; }));
  const TestFolder elsewhere;
  const Outcome other = run_program(
      elsewhere.path(), {"run", (folder.path() / "two.toml").string(), "--out", (folder.path() / "results").string()});
  EXPECT_EQ(other.code, 0);
  EXPECT_NE(other.err.find("1 ok, 1 left to another process"), std::string::npos) << other.err;
  EXPECT_EQ(count_starting(results, ".tmp-sphere"), 1U);  // the other process is alive
  holder.signal(SIGINT);
  holder.wait();
}

TEST(Runner, TheDryRunSaysWhatIsDoneAndWhatIsLeft) {
  const TestFolder folder;
  folder.write("two.toml", two_datasets);
  const fs::path results = folder.path() / "results" / "two";
  const auto expect_plan = [&](const std::string& sphere, const std::string& slab, const std::string& sum) {
    const Outcome outcome = run_program(folder.path(), {"run", "two.toml", "--dry-run"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.out.find(sphere + "  sphere-marching-cubes-"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find(slab + "  slab-marching-cubes-"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("2 runs in results/two: " + sum + "\n"), std::string::npos) << outcome.out;
  };
  expect_plan("to do    ", "to do    ", "2 to do");
  EXPECT_FALSE(fs::exists(folder.path() / "results"));
  run_program(folder.path(), {"run", "two.toml", "--only", "sphere/*"}, {{"ISOBENCH_TEST_FAULT", "crash:sphere/*"}});
  expect_plan("retry    ", "to do    ", "1 to do, 1 retry");
  run_program(folder.path(), {"run", "two.toml", "--only", "sphere/*"});
  const TestFolder elsewhere;
  Program holder(elsewhere.path(),
                 {"run", (folder.path() / "two.toml").string(), "--out", (folder.path() / "results").string()},
                 {{"ISOBENCH_TEST_FAULT", "hang:slab/*"}});
  EXPECT_TRUE(eventually([&] { return count_starting(results, ".tmp-slab") == 1; }));
  expect_plan("done     ", "elsewhere", "1 elsewhere, 1 done");
  holder.signal(SIGKILL);
  holder.wait();
  // A killed process holds no claim.
  expect_plan("done     ", "to do    ", "1 to do, 1 done");
  EXPECT_EQ(count_starting(results, ".tmp-slab"), 1U);  // a dry run removes nothing
}

TEST(Runner, RepeatsAreKeptApartAndGiveTheSameMesh) {
  const TestFolder folder;
  folder.write("timed.toml", "repeats = 3\n" + std::string(two_datasets));
  const Outcome outcome = run_program(folder.path(), {"run", "timed.toml", "--only", "slab/*", "--jobs", "3"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const fs::path results = folder.path() / "results" / "timed";
  EXPECT_EQ(count_starting(results, "slab-marching-cubes-e1-d0.5-s1-r"), 2U);
  EXPECT_EQ(count_starting(results, "slab-"), 3U);
  const RunRecord first = record_of(results, "slab-marching-cubes-e1-d0.5-s1-r2-");
  const RunRecord second = record_of(results, "slab-marching-cubes-e1-d0.5-s1-r3-");
  EXPECT_EQ(first.request.repeat, 2);
  EXPECT_EQ(first.mesh_checksum.size(), 64U);
  EXPECT_EQ(first.mesh_checksum, second.mesh_checksum);
  EXPECT_NE(outcome.out.find("marching-cubes (3 repeats)"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("| the same mesh"), std::string::npos) << outcome.out;
}

// The largest number of children at one time, counted by their temporary folders.
std::size_t most_at_once(const TestFolder& folder, const std::string& config, const fs::path& results) {
  Program program(folder.path(), {"run", config, "--jobs", "2"}, {{"ISOBENCH_TEST_FAULT", "hang:*"}});
  EXPECT_TRUE(eventually([&] { return fs::exists(results) && count_starting(results, ".tmp-") > 0; }));
  // If there is a second child, it starts in the same turn of the loop, so half a second is enough.
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  const std::size_t most = count_starting(results, ".tmp-");
  program.signal(SIGINT);
  EXPECT_EQ(program.wait().code, 130);
  return most;
}

TEST(Runner, TimedRunsGoAloneWhateverTheJobs) {
  const TestFolder folder;
  folder.write("timed.toml", "timing = true\n" + std::string(two_datasets));
  folder.write("plain.toml", two_datasets);
  EXPECT_EQ(most_at_once(folder, "plain.toml", folder.path() / "results" / "plain"), 2U);
  EXPECT_EQ(most_at_once(folder, "timed.toml", folder.path() / "results" / "timed"), 1U);
}

TEST(Runner, TimedRunsWaitForThoseOfAnotherProcess) {
  const TestFolder folder;
  folder.write("timed.toml", "timing = true\n" + std::string(two_datasets));
  const fs::path results = folder.path() / "results" / "timed";
  Program holder(folder.path(), {"run", "timed.toml", "--only", "sphere/*"},
                 {{"ISOBENCH_TEST_FAULT", "hang:sphere/*"}});
  EXPECT_TRUE(eventually([&] { return fs::exists(results) && count_starting(results, ".tmp-sphere") == 1; }));
  const TestFolder elsewhere;
  Program other(elsewhere.path(), {"run", (folder.path() / "timed.toml").string(), "--only", "slab/*", "--out",
                                   (folder.path() / "results").string()});
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  EXPECT_EQ(count_starting(results, "slab") + count_starting(results, ".tmp-slab"), 0U);
  holder.signal(SIGKILL);
  holder.wait();
  EXPECT_EQ(other.wait().code, 0);
  EXPECT_EQ(count_starting(results, "slab"), 1U);
}

TEST(Runner, TwoConfigsOfOneNameDoNotMix) {
  const TestFolder folder;
  folder.write("two.toml", two_datasets);
  ASSERT_EQ(run_program(folder.path(), {"run", "two.toml", "--only", "slab/*"}).code, 0);
  folder.write("two.toml", std::string(two_datasets) + "[[vary]]\nkey = \"sampling.delta\"\nvalues = 0.25\n");
  const Outcome refused = run_program(folder.path(), {"run", "two.toml"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("another config"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("--out"), std::string::npos) << refused.err;
  // Different limits do not make another experiment.
  folder.write("two.toml", std::string(two_datasets) + "[limits]\nminutes = 9\n");
  EXPECT_EQ(run_program(folder.path(), {"run", "two.toml", "--only", "slab/*"}).code, 0);
}

// Its config and its plan say how fine the lattice was on which the topology of F = c was counted.
TEST(Runner, AFolderOfAnOlderVersionIsReportedAndContinued) {
  const TestFolder folder;
  folder.write("two.toml", two_datasets);
  ASSERT_EQ(run_program(folder.path(), {"run", "two.toml"}).code, 0);
  const fs::path results = folder.path() / "results" / "two";
  std::ofstream(results / "config.toml", std::ios::app) << "\n[reference]\nk = 3\n";
  const auto make_old = [](const fs::path& file) {
    std::string text = read_text(file);
    for (std::size_t at = 0; (at = text.find("\"metrics_revision\"", at)) != std::string::npos; at += 40)
      text.insert(at, "\"reference_k\": 3, ");
    write_text(file, text);
    return text.find("\"reference_k\"") != std::string::npos;
  };
  EXPECT_TRUE(make_old(results / "plan.json"));
  for (const char* dataset : {"sphere", "slab"}) EXPECT_TRUE(make_old(run_folder(results, dataset) / "run.json"));
  const Outcome report = run_program(folder.path(), {"report", "results/two"});
  EXPECT_EQ(report.code, 0) << report.err;
  EXPECT_NE(report.out.find("| slab"), std::string::npos) << report.out;
  EXPECT_EQ(run_program(folder.path(), {"compare", "results/two", "results/two"}).code, 0);
  for (const char* config : {"two.toml", "results/two"}) {
    const Outcome again = run_program(folder.path(), {"run", config});
    EXPECT_EQ(again.code, 0) << again.err;
  }
  EXPECT_EQ(read_text(results / "config.toml").find("reference"), std::string::npos);
  EXPECT_EQ(read_text(results / "plan.json").find("reference_k"), std::string::npos);
}

TEST(Runner, ADamagedRecordCostsOnlyItself) {
  const TestFolder folder;
  folder.write("two.toml", two_datasets);
  ASSERT_EQ(run_program(folder.path(), {"run", "two.toml"}).code, 0);
  const fs::path results = folder.path() / "results" / "two";
  const fs::path damaged = run_folder(results, "sphere") / "run.json";
  std::ofstream(damaged) << "{ \"schema_version\": 1, ";
  const Outcome report = run_program(folder.path(), {"report", "results/two"});
  EXPECT_EQ(report.code, 0);
  EXPECT_NE(report.out.find("not a readable run record"), std::string::npos);
  EXPECT_NE(report.out.find("| slab"), std::string::npos);
  EXPECT_EQ(run_program(folder.path(), {"run", "two.toml"}).code, 0);
  EXPECT_EQ(record_of(results, "sphere").status, Status::ok);
}

}  // namespace
}  // namespace isobench
