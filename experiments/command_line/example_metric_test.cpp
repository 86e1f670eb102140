// The metric that metrics/README.md prints, built into a program beside the others (isobench_with_example_metric).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "isobench/experiments/command_line/test_program.h"
#include "isobench/foundation/files/whole_files.h"
#include "isobench/methods/mesh_files/mesh_files.h"

namespace isobench {
namespace {

class ExampleMetric : public testing::Test {
 protected:
  Outcome run(const std::vector<std::string>& arguments) { return run_program(folder_.path(), arguments); }
  TestFolder folder_;
};

TEST_F(ExampleMetric, IsListedWithItsDefinition) {
  const std::string metrics = run({"list", "metrics"}).out;
  EXPECT_NE(metrics.find("Largest aspect ratio of any triangle. Not measured where a triangle has no area."),
            std::string::npos)
      << metrics;
  EXPECT_NE(metrics.find("\nsliver_count "), std::string::npos) << metrics;
  EXPECT_NE(run({"list", "columns"}).out.find("\nsliver_count "), std::string::npos);
}

TEST_F(ExampleMetric, IsInTheTableAndInTheRecordOfARun) {
  folder_.write("x.toml", R"(dataset = "sphere"
[sampling]
edge_length = 2
[[method]]
name = "marching-cubes"
)");
  const Outcome outcome = run({"run", "x.toml", "-q"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::filesystem::path results = folder_.path() / "results" / "x";
  std::istringstream csv(read_text_or_empty(results / "results.csv"));
  std::string header;
  std::string row;
  std::getline(csv, header);
  std::getline(csv, row);
  EXPECT_NE(header.find(",area,volume,aspect_ratio_max,sliver_count,"), std::string::npos) << header;
  const std::vector<std::string> columns = fields(header);
  const auto column = std::find(columns.begin(), columns.end(), "aspect_ratio_max") - columns.begin();
  const double in_csv = std::stod(fields(row).at(static_cast<std::size_t>(column)));
  EXPECT_GT(in_csv, 2.0 / std::sqrt(3.0)) << "an equilateral triangle has the smallest aspect ratio";
  EXPECT_NE(
      read_text_or_empty(results / "results.columns.md").find("Number of triangles with an aspect ratio above 10."),
      std::string::npos);

  const std::string json = read_text_or_empty(run_folder(results, "sphere-") / "run.json");
  const std::size_t at = json.find("\"aspect_ratio_max\": ");
  ASSERT_NE(at, std::string::npos) << json;
  EXPECT_EQ(std::stod(json.substr(at + 20)), in_csv);
  EXPECT_NE(json.find("\"aspect_ratio\": {"), std::string::npos) << "the histogram";
  const TriangleMesh mesh = read_mesh(run_folder(results, "sphere-") / "mesh.vtp");
  EXPECT_EQ(mesh.triangle_data.at("aspect_ratio").size(), mesh.triangles.size());
}

TEST_F(ExampleMetric, SaysWhatItCouldNotMeasure) {
  folder_.write("flat.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n3 0 1 2\n3 0 1 3\n");
  const Outcome outcome = run({"measure", "flat.off", "--json", "-q"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\"aspect_ratio_max\": null"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\"sliver_count\": 1"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace isobench
