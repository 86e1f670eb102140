#include "isobench/reports/survey/survey.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/survey/sample_survey.h"
#include "isobench/reports/survey/side_by_side.h"

namespace isobench {
namespace {

std::size_t check_number(const std::string& column) {
  return static_cast<std::size_t>(&check(column) - checks().data());
}

const PassCount& count_of_check(const Tally& tally, const std::string& column) {
  return tally.checks.at(check_number(column));
}

std::optional<bool> answer(const std::string& column, const std::map<std::string, std::optional<double>>& changes) {
  RunRecord run = sample_survey::good(0);
  for (const auto& [figure, value] : changes) run.measurement->set(figure, value);
  return passes(check(column), run);
}

TEST(Checks, OneFigureOutOfBoundsDecides) {
  for (const Check& each : checks()) EXPECT_EQ(answer(each.column, {}), true) << each.column;
  EXPECT_EQ(answer("closed_manifold", {{"misoriented_edges", 1.0}}), false);
  EXPECT_EQ(answer("right_topology", {{"components", 2.0}}), false);
  EXPECT_EQ(answer("right_topology", {{"euler", 0.0}}), false);
  EXPECT_EQ(answer("right_topology", {{"boundary_edges", 3.0}}), false);
  EXPECT_EQ(answer("no_self_intersections", {{"self_intersections", 1.0}}), false);
  EXPECT_EQ(answer("angles_35_90", {{"angle_min", 34.9}}), false);
  EXPECT_EQ(answer("angles_35_90", {{"angle_max", 90.1}}), false);
  EXPECT_EQ(answer("angles_30_100", {{"angle_min", 34.9}, {"angle_max", 90.1}}), true);
  EXPECT_EQ(answer("angles_30_100", {{"angle_max", 100.1}}), false);
  EXPECT_EQ(answer("valences_5_7", {{"valence_extreme_count", 1.0}}), false);
  EXPECT_EQ(answer("no_edge_above_h0", {{"edge_over_h0_exceed_count", 1.0}}), false);
  EXPECT_THROW(check("no_such_column"), std::logic_error);
}

TEST(Checks, WhatWasNotMeasuredDoesNotPass) {
  EXPECT_EQ(answer("closed_manifold", {{"boundary_edges", std::nullopt}}), std::nullopt);
  EXPECT_EQ(answer("right_topology", {{"euler_reference", std::nullopt}}), std::nullopt);
  EXPECT_EQ(answer("no_self_intersections", {{"self_intersections", std::nullopt}}), std::nullopt);
  EXPECT_EQ(answer("angles_35_90", {{"angle_min", std::nullopt}}), std::nullopt);
  // The largest angle alone says no.
  EXPECT_EQ(answer("angles_35_90", {{"angle_min", std::nullopt}, {"angle_max", 95.0}}), false);
  EXPECT_EQ(answer("no_edge_above_h0", {{"edge_over_h0_exceed_count", std::nullopt}}), std::nullopt);
  RunRecord without_mesh = sample_survey::slow(19);
  EXPECT_EQ(passes(check("closed_manifold"), without_mesh), std::nullopt);
}

TEST(Survey, NeedsEnoughDataSetsForOneMethod) {
  const Results few = sample_survey::results(many_datasets - 1);
  EXPECT_FALSE(has_many_datasets(arrange_runs(few)));
  Results one = few;
  one.records.push_back(sample_survey::good(many_datasets));
  const RunGrid runs = arrange_runs(one);
  EXPECT_TRUE(has_many_datasets(runs));
  ASSERT_EQ(surveyed(runs).size(), 1U);
  EXPECT_EQ(surveyed(runs).front()->name, "good");
}

TEST(Survey, CountsHowOftenMeshesPass) {
  const Results results = sample_survey::results(60);
  const RunGrid runs = arrange_runs(results);
  EXPECT_EQ(families_of(runs), (std::vector<std::string>{"random-field", "islands", "mask"}));
  const Tally good = tally(runs, runs.variants[0]);
  for (const PassCount& count : good.checks) EXPECT_EQ(count.passed, 60U);
  EXPECT_EQ(good.sound.passed, 60U);
  const Tally fast = tally(runs, runs.variants[1]);
  EXPECT_EQ(count_of_check(fast, "closed_manifold").passed, 54U);
  // Every fourth is wrong and every tenth open; every twentieth is both.
  EXPECT_EQ(count_of_check(fast, "right_topology").passed, 60U - 15U - 6U + 3U);
  EXPECT_EQ(count_of_check(fast, "closed_manifold").not_passed.front(), "random-field-0000");
  EXPECT_EQ(count_of_check(fast, "angles_30_100").passed, 0U);
  const Tally slow = tally(runs, runs.variants[2]);
  EXPECT_EQ(slow.ends.at(Status::ok), 57U);
  EXPECT_EQ(slow.ends.at(Status::timeout), 3U);
  // A data set without a mesh does not pass.
  EXPECT_EQ(count_of_check(slow, "closed_manifold").passed, 57U);
  EXPECT_EQ(count_of_check(slow, "closed_manifold").asked, 60U);
  EXPECT_EQ(tally(runs, runs.variants[1], "islands").datasets, 20U);
}

TEST(Survey, AFigureThatWasNotMeasuredCountsNeitherWay) {
  Results results = sample_survey::results(10);
  results.records[0].measurement->set("euler_reference", std::nullopt);
  results.records[3].measurement->set_unknown(figure_index("self_intersections"));
  results.records[3].measurement->set("self_intersections", std::nullopt);
  const RunGrid runs = arrange_runs(results);
  const Tally good = tally(runs, runs.variants[0]);
  EXPECT_EQ(count_of_check(good, "right_topology").passed, 9U);
  EXPECT_EQ(count_of_check(good, "right_topology").asked, 9U);
  EXPECT_EQ(count_of_check(good, "right_topology").not_measured, 1U);
  EXPECT_EQ(good.sound.asked, 8U);
  EXPECT_EQ(good.sound.not_measured, 2U);
}

TEST(Survey, ADataSetCountsOnceAndPassesIfAllItsSeedsDo) {
  Results results = sample_survey::results(10);
  RunRecord again = results.records[0];
  again.request.seed = 2;
  again.measurement->set("self_intersections", 3);
  again.measurement->set("radius_ratio_min", 0.1);
  results.records.push_back(again);
  const RunGrid runs = arrange_runs(results);
  const Tally good = tally(runs, runs.variants[0]);
  EXPECT_EQ(good.datasets, 10U);
  EXPECT_EQ(count_of_check(good, "no_self_intersections").passed, 9U);
  const Criterion& ratio = quality_criterion("radius-ratio-min");
  const double first = figure_value(results.records[0], "radius_ratio_min");
  EXPECT_DOUBLE_EQ(value_on(runs, runs.variants[0], sample_survey::dataset(0), ratio), 0.5 * (first + 0.1));
  EXPECT_EQ(values_over(runs, runs.variants[0], ratio).size(), 10U);
}

TEST(Survey, NamesTheWorstCase) {
  Results results = sample_survey::results(30);
  results.records[3 * 17].measurement->set("radius_ratio_min", 0.31);
  results.records[3 * 17].measurement->set("boundary_edges", 1);  // an open mesh counts, too
  results.records[3 * 18].measurement->set("angle_max", 120.0);
  results.records[3 * 18].measurement->set("euler", 6);
  const RunGrid runs = arrange_runs(results);
  const WorstCase ratio = worst_case(runs, runs.variants[0], quality_criterion("radius-ratio-min"));
  ASSERT_NE(ratio.run, nullptr);
  EXPECT_EQ(ratio.run->request.dataset, sample_survey::dataset(17));
  EXPECT_EQ(ratio.value, 0.31);
  EXPECT_EQ(worst_case(runs, runs.variants[0], quality_criterion("angle-max")).value, 120.0);
  for (const Criterion& criterion : defect_criteria()) {
    if (criterion.id != "euler") continue;
    EXPECT_EQ(worst_case(runs, runs.variants[0], criterion).value, 4.0);
    EXPECT_EQ(worst_case(runs, runs.variants[0], criterion, "islands").value, 0.0);
  }
}

TEST(Survey, ComparesMethodsOnTheDataSetsThatAllHave) {
  Results results = sample_survey::results(40);
  for (std::size_t n = 40; n < 60; ++n) results.records.push_back(sample_survey::good(n));
  // A method with too few data sets must not shrink what the others share.
  results.records.push_back(sample_survey::record(0, "tried once"));
  const RunGrid runs = arrange_runs(results);
  const SideBySide side = side_by_side(runs, quality_criterion("radius-ratio-min"));
  ASSERT_EQ(side.methods.size(), 3U);
  EXPECT_EQ(side.datasets.size(), 40U);
  EXPECT_TRUE(std::isinf(side.costs[1][0]));   // open
  EXPECT_TRUE(std::isinf(side.costs[2][19]));  // out of time
  EXPECT_FALSE(std::isinf(side.costs[1][1]));
  const std::vector<double> ranks = average_ranks(side.costs);
  EXPECT_EQ(ranks[0], 1.0);
  // "slow" fails on 2 of 40 and is third there; "fast" is third elsewhere.
  EXPECT_NEAR(ranks[2], (38.0 * 2.0 + 2.0 * 3.0) / 40.0, 1e-12);
}

TEST(Survey, SecondsThatWereTimedOtherwiseAreNotCompared) {
  Results results = sample_survey::results(20);
  results.records[0].threads = 7;
  const RunGrid runs = arrange_runs(results);
  const Criterion& seconds = quality_criterion("seconds-per-1000-vertices");
  EXPECT_EQ(side_by_side(runs, seconds).datasets.size(), 19U);
  EXPECT_EQ(side_by_side(runs, quality_criterion("radius-ratio-min")).datasets.size(), 20U);
  EXPECT_EQ(values_over(runs, runs.variants[0], seconds).size(), 19U);
}

TEST(Survey, OpensWithTheDataSetThatMostMethodsClose) {
  Results results = sample_survey::results(20);
  EXPECT_EQ(opening_dataset(arrange_runs(results)), sample_survey::dataset(1));  // "fast" leaves the first one open
  for (RunRecord& record : results.records) record.status = Status::failed;
  EXPECT_EQ(opening_dataset(arrange_runs(results)), "");
}

}  // namespace
}  // namespace isobench
