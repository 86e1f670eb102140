// `isobench compare` on results folders that `isobench run` made.
#include <gtest/gtest.h>

#include "isobench/experiments/command_line/test_program.h"

namespace isobench {
namespace {

namespace fs = std::filesystem;

const char* const particles_experiment = R"(dataset = "small.toml"
[sampling]
epsilon = 1.0
delta = 0.5
[[method]]
name = "particles"
[[method]]
name = "marching-cubes"
)";

const char* const cubes_experiment = R"(dataset = ["sphere", "torus"]
[sampling]
edge_length = 2
[[method]]
name = "marching-cubes"
[[method]]
name = "flying-edges"
)";

class Compare : public testing::Test {
 protected:
  Outcome run(const std::vector<std::string>& arguments) { return run_program(folder_.path(), arguments); }
  // Runs the same config twice, into folders a and b.
  void run_twice(const char* config) {
    folder_.write("small.toml", "title = \"Small\"\n[phantom]\nname = \"sphere\"\nnodes = 24\n");
    folder_.write("two.toml", config);
    ASSERT_EQ(run({"run", "two.toml", "-q", "--out", "a"}).code, 0);
    ASSERT_EQ(run({"run", "two.toml", "-q", "--out", "b", "--threads", "1"}).code, 0);
  }
  fs::path record_in(const std::string& results, const std::string& start) {
    for (const auto& entry : fs::directory_iterator(folder_.path() / results)) {
      if (entry.path().filename().string().starts_with(start)) return entry.path() / "run.json";
    }
    return {};
  }
  TestFolder folder_;
};

TEST_F(Compare, TwoRunsOfOneConfigDifferInNothingButSeconds) {
  run_twice(particles_experiment);
  const Outcome same = run({"compare", "a/two", "b/two"});
  EXPECT_EQ(same.code, 0) << same.out << same.err;
  EXPECT_EQ(same.out.find("2 runs are the same on both sides, except for seconds and memory"), 0U) << same.out;
  EXPECT_EQ(std::count(same.out.begin(), same.out.end(), '\n'), 1) << same.out;
  EXPECT_NE(same.out.find("threads"), std::string::npos) << same.out;  // the circumstance that differs
  EXPECT_NE(run({"compare", "a/two", "b/two", "-v"}).out.find("## Seconds"), std::string::npos);
}

TEST_F(Compare, AStoredFolderIsMadeAgainElsewhereAndCompared) {
  folder_.write("two.toml", cubes_experiment);
  ASSERT_EQ(run({"run", "two.toml", "-q", "--out", "a", "--threads", "2"}).code, 0);
  fs::rename(folder_.path() / "a" / "two", folder_.path() / "as-it-came");
  fs::remove(folder_.path() / "two.toml");
  const Outcome again = run({"run", "as-it-came", "--out", "mine", "--threads", "1"});
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_NE(again.out.find("4 runs are the same on both sides, except for seconds and memory"), std::string::npos)
      << again.out;
  EXPECT_NE(again.out.find("| threads | 2   | 1   | 4    |"), std::string::npos) << again.out;
  EXPECT_TRUE(fs::exists(folder_.path() / "mine" / "as-it-came" / "results.csv"));
  // Without --out the folder itself is continued.
  const Outcome here = run({"run", "as-it-came"});
  EXPECT_EQ(here.code, 0) << here.err;
  EXPECT_NE(here.err.find("4 done before"), std::string::npos) << here.err;
  const Outcome nothing = run({"run", "mine"});
  EXPECT_EQ(nothing.code, 2);
  EXPECT_NE(nothing.err.find("holds no results"), std::string::npos) << nothing.err;
}

TEST_F(Compare, AFigureThatDiffersIsShownAndExitsWith1) {
  run_twice(cubes_experiment);
  const fs::path record = record_in("b/two", "torus-marching-cubes");
  std::string text = read_text(record);
  const std::size_t at = text.find("\"triangles\": ");
  ASSERT_NE(at, std::string::npos);
  text.insert(at + 13, 1, '1');
  std::ofstream(record) << text;
  fs::remove_all(record_in("b/two", "sphere-flying-edges").parent_path());
  const Outcome outcome = run({"compare", "a/two", "b/two"});
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("1 of 3 runs in both differ, 1 run only in A."), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("| triangles "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("(not done there)"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("| vertices "), std::string::npos) << outcome.out;
  EXPECT_EQ(run({"compare", "a/two", "b/two", "--tolerance", "-1"}).code, 2);
  EXPECT_EQ(run({"compare", "a/two", "nowhere"}).code, 3);
}

}  // namespace
}  // namespace isobench
