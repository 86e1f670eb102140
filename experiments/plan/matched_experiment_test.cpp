// Whole experiments with match = "vertices": their records and tables.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "isobench/experiments/command_line/test_program.h"
#include "isobench/reports/runs/results.h"

namespace isobench {
namespace {

const char* const experiment = R"(dataset = "small.toml"
match = "vertices"
match_to = "particles"
[sampling]
epsilon = 0.4
delta = 0.5
[[method]]
name = "marching-cubes"
[[method]]
name = "particles"
finish = 0
label = "looser"
contraction = 1.1
[[method]]
name = "particles"
finish = 0
)";

void write_experiment(const TestFolder& folder) {
  // A sphere of a few voxels takes a moment, even under a sanitizer.
  folder.write("small.toml", "title = \"Small\"\n[phantom]\nname = \"sphere\"\nnodes = 24\n");
  folder.write("match.toml", experiment);
}

std::map<std::string, RunRecord> records_by_label(const TestFolder& folder) {
  std::map<std::string, RunRecord> records;
  for (RunRecord& record : load_results(folder.path() / "results" / "match").records) {
    const std::string label = record.request.label;
    records.emplace(label, std::move(record));
  }
  return records;
}

TEST(MatchedExperiment, BringsTheOthersToTheNumberOfVertices) {
  const TestFolder folder;
  write_experiment(folder);
  const Outcome outcome = run_program(folder.path(), {"run", "match.toml", "--jobs", "3"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto records = records_by_label(folder);
  const RunRecord& particles = records.at("particles");
  const RunRecord& looser = records.at("looser");
  const RunRecord& cubes = records.at("marching-cubes");
  EXPECT_FALSE(particles.match.has_value());

  const auto vertices = particles.measurement->number("vertices");
  ASSERT_TRUE(looser.match.has_value());
  EXPECT_EQ(looser.match->vertices, vertices);
  EXPECT_EQ(looser.match->reason, "");
  EXPECT_NEAR(looser.measurement->number("vertices"), vertices, 0.02 * vertices);
  // A smaller contraction gives fewer vertices; to make up for it, edges must be shorter by about 1.1/1.5.
  EXPECT_NEAR(looser.match->scale, 1.1 / 1.5, 0.05);
  EXPECT_GE(looser.match->tries, 2);
  // The mesh is measured against the h0 that the config asks for, not against the scaled one.
  EXPECT_NEAR(looser.sizing->largest, particles.sizing->largest, 1e-12);
  // The record describes the mesh that was kept, not all tries together: its trace has the sweeps of one mesh.
  EXPECT_EQ(looser.traces.at("energy").size(), particles.traces.at("energy").size());

  ASSERT_TRUE(cubes.match.has_value());
  EXPECT_EQ(cubes.match->reason, "its number of vertices does not follow the sizing");
  EXPECT_EQ(cubes.match->scale, 1.0);
  EXPECT_NE(outcome.out.find("‡ its number of vertices does not follow the sizing"), std::string::npos);
  EXPECT_NE(outcome.out.find("Matching the number of vertices"), std::string::npos);
}

TEST(MatchedExperiment, SelectingARunBringsTheOneThatItIsMatchedTo) {
  const TestFolder folder;
  write_experiment(folder);
  const Outcome outcome = run_program(folder.path(), {"run", "match.toml", "--only", "*/looser"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto records = records_by_label(folder);
  EXPECT_EQ(records.count("looser") + records.count("particles"), 2U);
  EXPECT_EQ(records.count("marching-cubes"), 0U);
}

TEST(MatchedExperiment, WithoutTheOtherMeshARunFailsAndIsTriedAgain) {
  const TestFolder folder;
  write_experiment(folder);
  const Outcome crashed =
      run_program(folder.path(), {"run", "match.toml"}, {{"ISOBENCH_TEST_FAULT", "crash:small-particles-*"}});
  EXPECT_EQ(crashed.code, 1);
  const auto failed = records_by_label(folder);
  const std::string cause = "cannot be matched: " + failed.at("particles").request.run + " has no mesh";
  EXPECT_EQ(failed.at("looser").reason, cause);
  EXPECT_EQ(failed.at("marching-cubes").reason, cause);
  const Outcome again = run_program(folder.path(), {"run", "match.toml"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(records_by_label(folder).at("looser").match->reason, "");
}

}  // namespace
}  // namespace isobench
