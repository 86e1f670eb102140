// What the program does when the disk fills while it writes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "isobench/experiments/command_line/test_program.h"
#include "isobench/foundation/testing/file_size_limit.h"

namespace isobench {
namespace {

namespace fs = std::filesystem;

/// Every file below a folder, with its bytes. What the program printed is left out.
std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder).string();
    if (entry.is_regular_file() && !name.starts_with("std") && name.find(".locks") == std::string::npos)
      files[name] = read_text(entry.path());
  }
  return files;
}

/// One sentence on one line, which names the file.
void expect_full(const Outcome& outcome, const std::string& file) {
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_NE(outcome.err.find(file + ": cannot be written: File too large; raise the limit"), std::string::npos)
      << outcome.err;
}

class FullDisk : public testing::Test {
 protected:
  Outcome run_when_full(const std::vector<std::string>& arguments, std::size_t bytes) {
    const FileSizeLimit full(bytes);
    return run_program(folder_.path(), arguments);
  }
  TestFolder folder_;
};

TEST_F(FullDisk, AMeshLeavesTheOldFile) {
  for (const char* ending : {"stl", "vtp"}) {
    const std::string name = fmt::format("old.{}", ending);
    folder_.write(name, "old");
    const auto before = contents(folder_.path());
    const Outcome outcome =
        run_when_full({"mesh", "--dataset", "torus", "--method", "marching-cubes", "-q", "-o", name}, 5000);
    expect_full(outcome, name);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(contents(folder_.path()), before);
  }
}

const char* const small_experiment = R"(dataset = "torus"
[sampling]
edge_length = 2
[[method]]
name = "marching-cubes"
)";

TEST_F(FullDisk, AReportLeavesTheOldOne) {
  folder_.write("small.toml", small_experiment);
  ASSERT_EQ(run_program(folder_.path(), {"run", "small.toml", "-q"}).code, 0);
  const auto before = contents(folder_.path());
  expect_full(run_when_full({"report", "results/small", "-q"}, 300), "results/small/results.csv");
  EXPECT_EQ(contents(folder_.path()), before);
}

TEST_F(FullDisk, ARunIsStoredAsFailedAndDoneLater) {
  folder_.write("small.toml", small_experiment);
  // Enough for every file but the mesh.
  const Outcome failed = run_when_full({"run", "small.toml", "-q"}, 60000);
  EXPECT_EQ(failed.code, 1) << failed.err;
  const fs::path results = folder_.path() / "results/small";
  const RunRecord record = record_of(results, "torus");
  EXPECT_EQ(record.status, Status::failed);
  EXPECT_NE(record.reason.find("mesh.vtp: cannot be written: File too large; "), std::string::npos) << record.reason;
  EXPECT_FALSE(fs::exists(run_folder(results, "torus") / "mesh.vtp"));

  EXPECT_EQ(run_program(folder_.path(), {"run", "small.toml", "-q"}).code, 0);
  EXPECT_EQ(record_of(results, "torus").status, Status::ok);
}

TEST_F(FullDisk, ARunThatCannotBeRecordedLeavesNothing) {
  folder_.write("small.toml", small_experiment);
  const Outcome nothing = run_when_full({"run", "small.toml", "-q"}, 300);
  expect_full(nothing, "results/small/plan.json");
  EXPECT_EQ(contents(folder_.path()).size(), 1U);
}

TEST_F(FullDisk, OutputThatIsLostIsAnError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  ChildProcess listing({.words = {ISOBENCH_PROGRAM, "list", "methods"},
                        .out = {ChildOutput::To::end_of_file, "/dev/full"},
                        .err = ChildOutput{ChildOutput::To::text, {}}});
  EXPECT_EQ(listing.wait().code, 1);
  EXPECT_NE(listing.err().find("No space left on device"), std::string::npos) << listing.err();
}

}  // namespace
}  // namespace isobench
