// A fault in one cell leaves all other cells alone.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>

#include "isobench/experiments/command_line/test_program.h"
#include "isobench/reports/runs/results.h"

namespace isobench {
namespace {

namespace fs = std::filesystem;

struct Fault {
  std::string kind;
  Status status;
  std::string reason;  ///< a part of the reason
};

const std::vector<Fault>& faults() {
  static const std::vector<Fault> all = {
      {"crash", Status::failed, "ended by SIGSEGV"},
      {"hang", Status::timeout, "not finished after 0.08 minutes"},
      {"memory", Status::out_of_memory, "needed more than 0.5 GB"},
      {"silent", Status::failed, "ended with exit code 0 and no record"},
      {"garbage", Status::failed, "left a run.json that is no run record"},
      {"foreign", Status::failed, "left the record of another run"},
      {"hollow", Status::failed, "recorded as ok without a mesh"},
      {"nan", Status::failed, "must be finite"},
      {"index", Status::failed, "vertex"},
      {"empty", Status::failed, "no triangles"},
  };
  return all;
}

/// Writes an experiment with a dataset named after each fault and a healthy one. Only one of its two methods fails.
void write_faults(const TestFolder& folder) {
  std::string datasets = "\"healthy\"";
  const std::string manifest = "title = \"Small\"\n[phantom]\nname = \"sphere\"\nnodes = 24\n";
  folder.write("healthy.toml", manifest);
  for (const Fault& fault : faults()) {
    folder.write(fault.kind + ".toml", manifest);
    datasets += ", \"" + fault.kind + "\"";
  }
  folder.write("bad.toml",
               fmt::format("dataset = [{}]\n[sampling]\nedge_length = 5\n[limits]\nminutes = 5\n"
                           "memory_gb = 0.5\n[[override]]\ndataset = \"hang\"\nmethod = \"marching-cubes\"\n"
                           "limits = {{ minutes = 0.08 }}\n[[method]]\nname = \"marching-cubes\"\n[[method]]\n"
                           "name = \"flying-edges\"\n",
                           datasets));
}

std::string every_fault() {
  std::string text;
  for (const Fault& fault : faults()) text += fmt::format("{0}:{0}/marching-cubes;", fault.kind);
  return text;
}

TEST(Isolation, EveryKindOfFaultCostsItsOwnCellAlone) {
  const TestFolder folder;
  write_faults(folder);
  const std::map<std::string, std::string> environment = {{"ISOBENCH_CATALOGUE", folder.path().string()},
                                                          {"ISOBENCH_TEST_FAULT", every_fault()}};
  const Outcome outcome = run_program(folder.path(), {"run", "bad.toml", "--jobs", "2"}, environment);
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  const fs::path results = folder.path() / "results" / "bad";
  const std::size_t bad = faults().size();
  EXPECT_NE(outcome.err.find(fmt::format("bad: {} ok, {} failed\n", bad + 2, bad)), std::string::npos) << outcome.err;

  const std::string tables = read_text(results / "tables.md");
  for (const Fault& fault : faults()) {
    SCOPED_TRACE(fault.kind);
    const RunRecord record = record_of(results, fault.kind + "-marching-cubes-");
    EXPECT_EQ(record.status, fault.status) << record.reason;
    EXPECT_NE(record.reason.find(fault.reason), std::string::npos) << record.reason;
    EXPECT_FALSE(record.measurement);
    EXPECT_NE(tables.find(record.reason), std::string::npos) << "every table says why";
    EXPECT_FALSE(fs::exists(run_folder(results, fault.kind + "-marching-cubes-") / "mesh.vtp"));
    EXPECT_EQ(record_of(results, fault.kind + "-flying-edges-").status, Status::ok);
  }
  EXPECT_EQ(record_of(results, "healthy-marching-cubes-").status, Status::ok);
  EXPECT_EQ(load_results(results).unreadable.size(), 0U);
  EXPECT_EQ(count_starting(results, ".tmp-"), 0U);

  // Without the faults the next start repeats the failed cells and no others.
  const Outcome again =
      run_program(folder.path(), {"run", "bad.toml"}, {{"ISOBENCH_CATALOGUE", folder.path().string()}});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_NE(again.err.find(fmt::format("bad: {} ok, {} done before\n", bad, bad + 2)), std::string::npos) << again.err;
}

}  // namespace
}  // namespace isobench
