#include "isobench/reports/runs/refinement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/record/sample_refinement.h"

namespace isobench {
namespace {

Order order_of(const std::vector<RunRecord>& records, const std::string& figure) {
  Results results;
  results.records = records;
  return order_of_convergence(refinements(results).front(), figure_of(figure));
}

TEST(Refinement, AnErrorThatIsAPowerOfHHasItsExponentAsOrder) {
  const std::vector<RunRecord> records = sample_levels("sphere", "ours", 0.3, 1.75);
  EXPECT_NEAR(order_of(records, "poisson_l2").value, 1.75, 1e-12);
  EXPECT_NEAR(order_of(records, "gradient_max").value, 1.0, 1e-12);
  EXPECT_EQ(order_of(records, "poisson_l2").untested, "");
}

TEST(Refinement, TheSlopeIsThatOfLeastSquares) {
  std::vector<RunRecord> records = sample_levels("sphere", "ours", 0.3, 2.0);
  // Equal steps of log h: the middle point does not change the slope, the ends do by half of what they move.
  records[1].measurement->set("poisson_l2", 10.0 * *records[1].measurement->figure("poisson_l2"));
  EXPECT_NEAR(order_of(records, "poisson_l2").value, 2.0, 1e-12);
  records[2].measurement->set("poisson_l2", 2.0 * *records[2].measurement->figure("poisson_l2"));
  EXPECT_NEAR(order_of(records, "poisson_l2").value, 1.5, 1e-12);
}

TEST(Refinement, LevelsAreSortedByTheirMeshesAndHoldAllSeeds) {
  Results results;
  results.records = {sample_level("sphere", "ours", 4000, 1, 2), sample_level("sphere", "ours", 1000, 1, 2),
                     sample_level("sphere", "ours", 4000, 1, 2), sample_level("torus", "ours", 4000, 1, 2),
                     sample_level("sphere", "ours", 9000, 1, 2)};
  results.records[2].request.seed = 2;
  results.records[4].request.aside = true;
  const std::vector<Refinement> all = refinements(results);
  ASSERT_EQ(all.size(), 2U);
  ASSERT_EQ(all[0].levels.size(), 2U);
  EXPECT_EQ(all[0].levels[0].size(), 1U);
  EXPECT_EQ(all[0].levels[1].size(), 2U);
  EXPECT_EQ(all[1].dataset, "torus");
}

TEST(Refinement, OnlyTheFinestRunsOfEachLabelCompete) {
  Results results;
  results.records = {sample_level("sphere", "ours", 4000, 1, 2),   sample_level("sphere", "ours", 1000, 1, 2),
                     sample_level("sphere", "ours", 4000, 1, 2),   sample_level("torus", "ours", 1000, 1, 2),
                     sample_level("sphere", "theirs", 1000, 1, 2), sample_level("sphere", "theirs", 4000, 1, 2)};
  results.records[2].request.seed = 2;
  const RunGrid finest = finest_runs(arrange_runs(results));
  ASSERT_EQ(finest.variants.size(), 2U);
  const Variant& ours = finest.variants.front();
  EXPECT_EQ(ours.name, "ours");
  EXPECT_EQ(find_runs(ours, "sphere"), (Runs{results.records.data(), &results.records[2]}));
  EXPECT_EQ(find_runs(ours, "torus"), Runs{&results.records[3]});
  EXPECT_EQ(find_runs(finest.variants.back(), "sphere"), Runs{&results.records[5]});
  EXPECT_TRUE(find_runs(finest.variants.back(), "torus").empty());
}

TEST(Refinement, WithoutThreeDifferentMeshesThereIsNoOrder) {
  std::vector<RunRecord> records = sample_levels("sphere", "ours", 0.3, 2.0);
  EXPECT_EQ(order_of({records[0], records[1]}, "poisson_l2").untested, "fewer than 3 sizings");
  std::vector<RunRecord> failed = records;
  failed[2].status = Status::timeout;
  failed[2].measurement.reset();
  EXPECT_EQ(order_of(failed, "poisson_l2").untested, "measured at fewer than 3 sizings");
  EXPECT_TRUE(std::isnan(order_of(failed, "poisson_l2").value));
  records[1] = without_use(records[1]);
  EXPECT_EQ(order_of(records, "poisson_l2").untested, "measured at fewer than 3 sizings");
  // Marching cubes meshes its lattice whatever the sizing.
  records = sample_levels("sphere", "marching-cubes", 0.3, 2.0);
  for (RunRecord& record : records) record.measurement->set("triangles", 2000);
  EXPECT_EQ(order_of(records, "poisson_l2").untested, "its meshes do not get finer");
}

TEST(Refinement, SecondsOfSolvingAreThoseOfTheirStage) {
  const RunRecord record = sample_level("sphere", "ours", 1000, 1, 2);
  EXPECT_EQ(solving_seconds(record), 0.75);
  EXPECT_TRUE(std::isnan(solving_seconds(sample_record("sphere", "ours"))));
}

}  // namespace
}  // namespace isobench
