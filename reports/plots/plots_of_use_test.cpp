#include <gtest/gtest.h>

#include <cmath>

#include "isobench/reports/plots/plots.h"
#include "isobench/reports/record/sample_refinement.h"

namespace isobench {
namespace {

std::vector<Plot> plots_for(const std::vector<RunRecord>& records) {
  Results results;
  results.records = records;
  return use_plots(results, arrange_runs(results));
}

Plot named(const std::vector<Plot>& plots, const std::string& name) {
  const auto found = std::find_if(plots.begin(), plots.end(), [&name](const Plot& plot) { return plot.name == name; });
  if (found == plots.end()) throw std::runtime_error("no plot " + name);
  return *found;
}

TEST(PlotsOfUse, ErrorsOverVerticesHaveAGuideOfTheirOrder) {
  const std::vector<Plot> plots = plots_for(sample_levels("sphere", "ours", 0.2, 2.0));
  ASSERT_EQ(plots.size(), 6U);
  const Plot l2 = named(plots, "poisson-l2-over-vertices-sphere");
  EXPECT_TRUE(l2.log_x && l2.log_y);
  ASSERT_EQ(l2.series.size(), 2U);
  EXPECT_EQ(l2.series[0].x, (std::vector<double>{1000.0, 4000.0, 16000.0}));
  EXPECT_NEAR(l2.series[0].y[0] / l2.series[0].y[2], 16.0, 1e-9);
  EXPECT_EQ(l2.series[1].name, "order 2 in h");
  EXPECT_NEAR(l2.series[1].y[0] / l2.series[1].y[1], 16.0, 1e-9);
  EXPECT_LT(l2.series[1].y[0], l2.series[0].y[0]);
  const Plot gradient = named(plots, "gradient-max-over-vertices-sphere");
  EXPECT_NEAR(gradient.series[1].y[0] / gradient.series[1].y[1], 4.0, 1e-9);
}

TEST(PlotsOfUse, SecondsAreThoseOfMeshingAndSolving) {
  const Plot plot =
      named(plots_for({sample_level("sphere", "ours", 1000, 0.2, 2.0)}), "poisson-max-over-seconds-sphere");
  EXPECT_EQ(plot.series.front().x, (std::vector<double>{5.25 + 0.75}));
}

TEST(PlotsOfUse, OneSizingHasNoPlotOverVertices) {
  std::vector<RunRecord> records = {sample_level("sphere", "ours", 1000, 0.2, 2.0)};
  EXPECT_EQ(plots_for(records).size(), 3U);
  // Marching cubes gives the same mesh at each sizing.
  records = sample_levels("sphere", "marching-cubes", 0.2, 2.0);
  for (RunRecord& record : records) record.measurement->set("vertices", 1000);
  EXPECT_EQ(plots_for(records).size(), 3U);
}

TEST(PlotsOfUse, AreNotThereWithoutTheFigures) {
  EXPECT_TRUE(plots_for({without_use(sample_record("sphere", "ours"))}).empty());
  std::vector<RunRecord> many;
  for (std::size_t n = 0; n <= many_datasets; ++n)
    many.push_back(sample_level("set-" + std::to_string(n), "ours", 1000, 0.2, 2.0));
  EXPECT_TRUE(plots_for(many).empty());
}

TEST(PlotsOfUse, AMethodKeepsItsColourOnAllDataSets) {
  std::vector<RunRecord> records = sample_levels("sphere", "ours", 0.2, 2.0);
  for (const RunRecord& record : sample_levels("sphere", "theirs", 0.2, 2.0)) records.push_back(record);
  for (const RunRecord& record : sample_levels("torus", "theirs", 0.2, 2.0)) records.push_back(record);
  const std::vector<Plot> plots = plots_for(records);
  EXPECT_EQ(named(plots, "poisson-l2-over-vertices-torus").series.front().colour,
            named(plots, "poisson-l2-over-vertices-sphere").series[1].colour);
}

}  // namespace
}  // namespace isobench
