#include <gtest/gtest.h>

#include "isobench/experiments/command_line/test_program.h"
#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/tables/sizing_grid.h"

namespace isobench {
namespace {

TEST(Sweep, ShowsBothTrendsOfThePapersFigure) {
  const TestFolder folder;
  const Outcome outcome = run_program(folder.path(), {"run", std::string(ISOBENCH_EXPERIMENTS) + "/sweep.toml", "-q"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Results results = load_results(folder.path() / "results" / "sweep");
  const std::vector<SizingGrid> grids = sizing_grids(results);
  ASSERT_EQ(grids.size(), 1U);
  ASSERT_EQ(grids[0].cells.size(), 9U);
  const auto of = [&grids](Along along, const Figure& figure) { return trend(grids[0], along, figure); };
  const Figure triangles = figure_of("triangles");
  const Figure distance = figure_of("distance_mean");
  const Figure smallest = figure_of("radius_ratio_min");
  const Figure average = figure_of("radius_ratio_avg");
  // "Smaller values of ε produce more geometrically accurate meshes, while smaller values of δ generate more regular
  // triangulations - smaller values of either parameter inherently increases the overall number of triangles."
  EXPECT_EQ(of(Along::epsilon, distance).falls, 6);
  EXPECT_EQ(of(Along::epsilon, triangles).rises, 6);
  EXPECT_EQ(of(Along::delta, smallest).rises, 6);
  EXPECT_EQ(of(Along::delta, average).rises, 6);
  EXPECT_EQ(of(Along::delta, triangles).rises, 6);
}

}  // namespace
}  // namespace isobench
