// Whatever an external program does, only its own run fails, and its log is kept.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "isobench/experiments/command_line/test_program.h"
#include "isobench/reports/runs/results.h"

namespace isobench {
namespace {

namespace fs = std::filesystem;

struct Case {
  std::string label;
  std::string script;  ///< $1 is the marching-cubes mesh, $2 the output
  Status status;
  std::string reason;  ///< a part of it
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"fine", "echo fine; cp $1 $2", Status::ok, ""},
      {"crash", "echo words; kill -SEGV $$", Status::failed, "sh ended by SIGSEGV"},
      {"code", "echo words; exit 3", Status::failed, "ended with exit code 3; its log ends: words"},
      {"hang", "echo words; (setsid sleep 1003 &); sleep 1002", Status::timeout, "not finished after 0.1 minutes"},
      {"memory", "echo words; x=$(head -c 700000000 /dev/zero | tr '\\0' x); sleep 100; echo ${#x}",
       Status::out_of_memory, "needed more than 0.5 GB"},
      {"nothing", "echo words", Status::failed, "did not write output.ply"},
      {"elsewhere", "echo words; cp $1 other.ply", Status::failed, "it wrote other.ply there"},
      {"broken", "echo words; head -c 3000 $1 > $2", Status::failed, "output.ply: "},
  };
  return all;
}

void write_programs(const TestFolder& folder) {
  folder.write("ball.toml", "title = \"Small\"\n[phantom]\nname = \"sphere\"\nnodes = 24\n");
  std::string text =
      "dataset = \"ball\"\n[sampling]\nedge_length = 5\n[limits]\nminutes = 5\nmemory_gb = 0.5\n"
      "[[override]]\nmethod = \"hang\"\nlimits = { minutes = 0.1 }\n[[method]]\nname = \"marching-cubes\"\n";
  for (const Case& one : cases()) {
    const fs::path script = folder.write(one.label + ".sh", one.script);
    text += fmt::format("[[method]]\nname = \"external\"\nlabel = \"{}\"\ncommand = \"sh {} {{mesh}} {{output}}\"\n",
                        one.label, script.string());
  }
  folder.write("peers.toml", text);
}

fs::path folder_of(const fs::path& results, const std::string& label) {
  for (const auto& entry : fs::directory_iterator(results)) {
    if (!fs::exists(entry.path() / "run.json")) continue;
    if (read_record(entry.path() / "run.json").request.label == label) return entry.path();
  }
  return {};
}

TEST(External, EveryWayToFailCostsItsOwnRunAlone) {
  const TestFolder folder;
  write_programs(folder);
  const Outcome outcome = run_program(folder.path(), {"run", "peers.toml", "--jobs", "2"},
                                      {{"ISOBENCH_CATALOGUE", folder.path().string()}});
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  const fs::path results = folder.path() / "results" / "peers";
  EXPECT_NE(outcome.err.find(fmt::format("2 ok, {} failed\n", cases().size() - 1)), std::string::npos) << outcome.err;
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.label);
    const fs::path run = folder_of(results, one.label);
    ASSERT_FALSE(run.empty());
    const RunRecord record = read_record(run / "run.json");
    EXPECT_EQ(record.status, one.status) << record.reason;
    EXPECT_NE(record.reason.find(one.reason), std::string::npos) << record.reason;
    const std::string log = read_text(run / "external.txt");
    EXPECT_NE(log.find("$ sh "), std::string::npos) << log;
    EXPECT_NE(log.find(one.status == Status::ok ? "\nfine\n" : "\nwords\n"), std::string::npos) << log;
    EXPECT_EQ(count_starting(run, "."), 0U) << "scratch folders are removed, however the program ended";
    EXPECT_EQ(fs::exists(run / "mesh.vtp"), one.status == Status::ok);
  }
  const RunRecord fine = read_record(folder_of(results, "fine") / "run.json");
  EXPECT_TRUE(std::any_of(fine.notes.begin(), fine.notes.end(), [](const std::string& note) {
    return note.find("ran sh ") != std::string::npos && note.ends_with("fine.sh mesh.ply output.ply");
  }));
  EXPECT_FALSE(fine.deterministic);
  EXPECT_FALSE(
      process_mentions(std::string("sleep\0"
                                   "1002",
                                   10)));
  EXPECT_FALSE(
      process_mentions(std::string("sleep\0"
                                   "1003",
                                   10)))
      << "a process that left the process group is stopped, too";
}

TEST(External, AnInterruptionStopsTheProgramAndAllThatItStarted) {
  const TestFolder folder;
  folder.write("ball.toml", "title = \"Small\"\n[phantom]\nname = \"sphere\"\nnodes = 24\n");
  folder.write("long.toml",
               "dataset = \"ball\"\n[sampling]\nedge_length = 5\n[[method]]\nname = \"external\"\n"
               "command = \"sh -c 'setsid sleep 1005 & sleep 1004'\"\n");
  Program program(folder.path(), {"run", "long.toml"}, {{"ISOBENCH_CATALOGUE", folder.path().string()}});
  const std::string one(
      "sleep\0"
      "1004",
      10);
  const std::string other(
      "sleep\0"
      "1005",
      10);
  ASSERT_TRUE(eventually([&] { return process_mentions(one) && process_mentions(other); }));
  program.signal(SIGINT);
  program.wait();
  EXPECT_TRUE(eventually([&] { return !process_mentions(one) && !process_mentions(other); }));
  EXPECT_EQ(count_starting(folder.path() / "results" / "long", ".tmp-"), 0U);
}

TEST(External, ACommandIsAskedForBeforeAnythingRuns) {
  const TestFolder folder;
  folder.write("ball.toml", "title = \"Small\"\n[phantom]\nname = \"sphere\"\nnodes = 24\n");
  const auto answer = [&folder](const std::string& entry) {
    folder.write("bad.toml", "dataset = \"ball\"\nsampling = { edge_length = 5 }\n" + entry);
    const Outcome outcome =
        run_program(folder.path(), {"run", "bad.toml"}, {{"ISOBENCH_CATALOGUE", folder.path().string()}});
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    return outcome.err;
  };
  EXPECT_NE(answer("[[method]]\nname = \"external\"\n").find("bad.toml:3:1: external needs 'command'"),
            std::string::npos);
  const std::string unknown = answer("[[method]]\nname = \"external\"\ncommand = \"a {vertice}\"\n");
  EXPECT_NE(unknown.find("bad.toml:5:"), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("unknown placeholder {vertice}; did you mean 'vertices'?"), std::string::npos) << unknown;
  const Outcome mesh =
      run_program(folder.path(), {"mesh", "--dataset", "torus", "--method", "external", "--edge-length", "5"});
  EXPECT_EQ(mesh.code, 2);
  EXPECT_NE(mesh.err.find("external needs --set command="), std::string::npos) << mesh.err;
}

}  // namespace
}  // namespace isobench
