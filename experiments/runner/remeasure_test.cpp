// `isobench measure` of a results folder.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "isobench/experiments/command_line/test_program.h"
#include "isobench/experiments/plan/plan.h"
#include "isobench/foundation/files/whole_files.h"
#include "isobench/foundation/testing/test_text.h"
#include "isobench/methods/mesh_files/mesh_files.h"
#include "isobench/reports/runs/results.h"

namespace isobench {
namespace {

namespace fs = std::filesystem;

class Remeasure : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("x.toml", R"(dataset = ["sphere", "slab"]
[sampling]
epsilon = 1.0
delta = 0.5
[[method]]
name = "marching-cubes"
)");
    const Outcome outcome = run_program(folder_.path(), {"run", "x.toml", "-q"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }
  fs::path results() const { return folder_.path() / "results" / "x"; }
  Outcome measure(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"measure", "results/x"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(folder_.path(), arguments);
  }
  RunRecord record(std::size_t index) const { return load_results(results()).records.at(index); }
  /// The cells of a column of results.csv, a run each.
  std::vector<std::string> column(const std::string& name) const {
    std::vector<std::string> values;
    std::size_t at = 0;
    for (const std::string& line : lines(read_text_or_empty(results() / "results.csv"))) {
      const std::vector<std::string> cells = csv_cells(line);
      if (values.empty()) at = static_cast<std::size_t>(std::find(cells.begin(), cells.end(), name) - cells.begin());
      values.push_back(cells.at(at));
    }
    values.erase(values.begin());
    return values;
  }
  fs::path run(std::size_t index) const { return results() / record(index).request.run; }

  TestFolder folder_;
};

// To 1e-9, because the mesh went to world coordinates and back. 1e-9 mm are about 300,000 units in the last place of a
// coordinate of 20 mm.
void expect_same_figures(const Measurement& a, const Measurement& b) {
  for (const FigureDeclaration& figure : declared_figures()) {
    ASSERT_EQ(a.figure(figure.name).has_value(), b.figure(figure.name).has_value()) << figure.name;
    if (!a.figure(figure.name)) continue;
    // An area is the sum of thousands of terms of some mm².
    const double tolerance = 1e-9 * std::max(1.0, std::abs(a.number(figure.name)) * 1e-3);
    EXPECT_NEAR(b.number(figure.name), a.number(figure.name), tolerance) << figure.name;
  }
}

TEST_F(Remeasure, TakesEveryFigureAgainAndKeepsWhatTheMeshTook) {
  const RunRecord before = record(0);
  RunRecord wrong = before;
  wrong.measurement->set("radius_ratio_min", 7.0);
  wrong.measurement->set("euler", 99);
  write_record(wrong, run(0) / "run.json");
  const Outcome outcome = measure();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("2 measured"), std::string::npos) << outcome.err;
  const RunRecord after = record(0);
  expect_same_figures(*before.measurement, *after.measurement);
  EXPECT_EQ(after.measurement->histogram("radius_ratio").counts, before.measurement->histogram("radius_ratio").counts);
  EXPECT_EQ(after.seconds_total, before.seconds_total);
  EXPECT_EQ(after.started, before.started);
  EXPECT_EQ(after.stages.size(), before.stages.size());
  EXPECT_EQ(after.mesh_checksum, before.mesh_checksum);
  EXPECT_FALSE(before.measured_again.has_value());
  ASSERT_TRUE(after.measured_again.has_value());
  EXPECT_EQ(after.measured_again->commit, before.environment.commit);
  EXPECT_TRUE(fs::exists(run(0) / "log.txt"));
  EXPECT_EQ(read_text(results() / "results.csv").find(",99,"), std::string::npos);
  // Nothing is left to do, and no temporary folder is left.
  const Outcome plan = run_program(folder_.path(), {"run", "x.toml", "--dry-run"});
  EXPECT_NE(plan.out.find(": 2 done"), std::string::npos) << plan.out;
  for (const auto& entry : fs::directory_iterator(results())) {
    const std::string name = entry.path().filename().string();
    EXPECT_FALSE(name.starts_with(".tmp-") || name.starts_with(".old-")) << name;
  }
}

TEST_F(Remeasure, PutsTheArraysIntoTheMeshAgainAndMovesNoVertex) {
  TriangleMesh mesh = read_mesh(run(0) / "mesh.vtp");
  const TriangleMesh before = mesh;
  mesh.vertex_data.clear();
  write_mesh(mesh, run(0) / "mesh.vtp");
  EXPECT_EQ(measure().code, 0);
  const TriangleMesh after = read_mesh(run(0) / "mesh.vtp");
  EXPECT_EQ(after.vertices, before.vertices);
  EXPECT_EQ(after.vertex_data.at("valence"), before.vertex_data.at("valence"));
  EXPECT_EQ(after.triangle_data.at("radius_ratio").size(), before.triangles.size());
}

TEST_F(Remeasure, AMeshThatIsNotItsRecordsIsLeftAlone) {
  TriangleMesh mesh = read_mesh(run(0) / "mesh.vtp");
  mesh.vertices[0].x() += 1e-6;
  write_mesh(mesh, run(0) / "mesh.vtp");
  fs::remove(run(1) / "mesh.vtp");
  const std::string before = read_text(run(0) / "run.json");
  const Outcome outcome = measure();
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("their checksums differ"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("mesh.vtp is missing"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("0 measured, 2 kept as they were"), std::string::npos) << outcome.err;
  EXPECT_EQ(read_text(run(0) / "run.json"), before);
}

TEST_F(Remeasure, RunsOfAnEarlierMetricsRevisionTakeTheNameOfThisOne) {
  // Make the folder look as if a program with other metrics had written it.
  std::vector<RunRequest> plan;
  for (RunRecord old : load_results(results()).records) {
    const fs::path from = results() / old.request.run;
    old.request.metrics_revision = metrics_revision + 1000;
    old.request.run = run_name(old.request);
    write_record(old, from / "run.json");
    fs::rename(from, results() / old.request.run);
    plan.push_back(old.request);
  }
  write_text(results() / "plan.json", plan_to_json(plan));
  EXPECT_NE(run_program(folder_.path(), {"run", "x.toml", "--dry-run"}).out.find(": 2 to do"), std::string::npos);
  EXPECT_EQ(measure().code, 0);
  EXPECT_NE(run_program(folder_.path(), {"run", "x.toml", "--dry-run"}).out.find(": 2 done"), std::string::npos);
  EXPECT_EQ(load_results(results()).records.size(), 2U);
  EXPECT_FALSE(fs::exists(results() / plan[0].run));
}

TEST_F(Remeasure, UnfinishedRunsHaveNothingToMeasure) {
  RunRecord failed = record(1);
  failed.status = Status::failed;
  failed.reason = "ended by SIGSEGV";
  failed.measurement.reset();
  write_record(failed, run(1) / "run.json");
  const Outcome outcome = measure();
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.err.find("1 measured, 1 without a mesh"), std::string::npos) << outcome.err;
  EXPECT_EQ(record(1).reason, "ended by SIGSEGV");
}

// A folder of an earlier version gets the figures that it lacks.
TEST_F(Remeasure, AddsFiguresThatTheRecordDidNotKnow) {
  for (std::size_t n : {0, 1}) {
    RunRecord old = record(n);
    for (const char* figure : {"area", "volume", "components_lost", "components_joined", "components_different"})
      old.measurement->set_unknown(figure_index(figure));
    write_record(old, run(n) / "run.json");
  }
  ASSERT_EQ(run_program(folder_.path(), {"report", "results/x"}).code, 0);
  EXPECT_EQ(column("area"), (std::vector<std::string>{"", ""}));
  EXPECT_EQ(column("components_different"), (std::vector<std::string>{"", ""}));
  EXPECT_EQ(measure().code, 0);
  EXPECT_GT(record(0).measurement->number("area"), 0.0);
  EXPECT_GT(record(1).measurement->number("volume"), 0.0);
  EXPECT_EQ(std::stod(column("area").at(0)), record(0).measurement->number("area"));
  EXPECT_EQ(column("components_different"), (std::vector<std::string>{"0", "0"}));
}

TEST_F(Remeasure, AddsMetricsOfUseAndKeepsThem) {
  EXPECT_FALSE(record(0).measurement->is_known(figure_index("step_factor")));
  EXPECT_TRUE(record(0).measurement->is_known(figure_index("negative_weights")));
  EXPECT_EQ(column("condition"), (std::vector<std::string>{"", ""}));
  EXPECT_EQ(measure().code, 0);
  EXPECT_FALSE(record(0).measurement->is_known(figure_index("step_factor"))) << "nobody asked for it";
  EXPECT_EQ(measure({"--metrics-of-use"}).code, 0);
  const double factor = record(0).measurement->number("step_factor");
  EXPECT_GT(factor, 6.0);
  EXPECT_EQ(std::stod(column("step_factor").at(0)), factor);
  EXPECT_EQ(measure().code, 0);
  EXPECT_EQ(record(0).measurement->number("step_factor"), factor);
  EXPECT_NE(run_program(folder_.path(), {"run", "x.toml", "--dry-run"}).out.find(": 2 done"), std::string::npos);
}

TEST_F(Remeasure, OfAFolderTakesNoOptionsOfAFile) {
  EXPECT_EQ(measure({"--dataset", "sphere"}).code, 2);
  EXPECT_EQ(measure({"--json"}).code, 2);
  EXPECT_EQ(measure({"--delta", "0.3"}).code, 2);
  EXPECT_EQ(measure({"--volume", "x.nrrd", "--isovalue", "1"}).code, 2);
  EXPECT_EQ(run_program(folder_.path(), {"measure", "results"}).code, 3);
}

}  // namespace
}  // namespace isobench
