#include "isobench/reports/tables/survey_tables.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "isobench/foundation/testing/test_text.h"
#include "isobench/reports/latex/latex.h"
#include "isobench/reports/survey/sample_survey.h"
#include "isobench/reports/tables/best_methods.h"
#include "isobench/reports/tables/tables.h"
#include "isobench/reports/tables_document.h"

namespace isobench {
namespace {

// The cell under a heading in the first row whose first cells are these; "no such row" or "no such column".
std::string cell(const Table& table, const std::vector<std::string>& labels, const std::string& column) {
  const auto found = std::find(table.header.begin(), table.header.end(), column);
  if (found == table.header.end()) return "no such column";
  for (const TableRow& row : table.rows) {
    bool same = true;
    for (std::size_t i = 0; i < labels.size(); ++i) same = same && row[i].text() == labels[i];
    if (same) return row[static_cast<std::size_t>(found - table.header.begin())].text();
  }
  return "no such row";
}

TEST(SurveyTables, ReliabilityHasCountsAndWilsonsIntervals) {
  Results results = sample_survey::results(60);
  results.records[0].measurement->set("euler_reference", std::nullopt);
  const Table table = reliability_table(arrange_runs(results));
  EXPECT_EQ(cell(table, {"good"}, "closed manifold"), "60 of 60 (94–100 %)");
  EXPECT_EQ(cell(table, {"good"}, "right topology"), "59 of 59 (93.9–100 %, 1 not measured)");
  EXPECT_EQ(cell(table, {"fast"}, "closed manifold"), "54 of 60 (79.9–95.3 %)");
  EXPECT_EQ(cell(table, {"slow"}, "Ended"), "57 ok, 3 timeout");
  EXPECT_EQ(cell(table, {"slow"}, "closed manifold"), "57 of 60 (86.3–98.3 %)");
  const Table families = family_reliability_table(arrange_runs(results));
  EXPECT_EQ(families.rows.size(), 9U);
  EXPECT_EQ(cell(families, {"islands", "good"}, "Data sets"), "20");
  EXPECT_EQ(sound_sentence(arrange_runs(results)),
            "Sound meshes (closed manifold, right topology, no self-intersections): good 59 of 59, fast 42 of 60, slow "
            "57 of 60.");
}

TEST(SurveyTables, NameWhatDoesNotPassAndTheWorst) {
  Results results = sample_survey::results(60);
  results.records[3 * 17].measurement->set("radius_ratio_min", 0.31);
  results.records[3 * 17].measurement->set("self_intersections", 2);
  const RunGrid runs = arrange_runs(results);
  const Table outliers = outlier_table(runs);
  EXPECT_EQ(cell(outliers, {"good", "no self-intersections"}, "Data sets"), "mask-0017");
  EXPECT_EQ(cell(outliers, {"good", "closed manifold"}, "Data sets"), "no such row");
  EXPECT_EQ(cell(outliers, {"slow", "closed manifold"}, "Data sets"), "islands-0019, random-field-0039, mask-0059");
  EXPECT_NE(cell(outliers, {"fast", "right topology"}, "Data sets").find(" and 8 more"), std::string::npos);
  const Table worst = worst_table(runs);
  EXPECT_EQ(cell(worst, {"Smallest radius ratio"}, "good"), "0.310 (mask-0017)");
  EXPECT_EQ(cell(worst, {"Self-intersections"}, "good"), "2 (mask-0017)");
  const Table families = family_table(runs);
  EXPECT_EQ(cell(families, {"mask", "good"}, "Smallest radius ratio"), "0.310 (mask-0017)");
  EXPECT_EQ(cell(families, {"mask", "good"}, "Sound"), "19 of 20");
  EXPECT_EQ(cell(families, {"islands", "good"}, "Sound"), "20 of 20");
}

TEST(SurveyTables, DistributionsRunFromWorstToBest) {
  // Radius ratios 0.00, 0.01, …, 1.00 and largest angles 60, 61, …, 160.
  Results results;
  for (std::size_t n = 0; n <= 100; ++n) {
    RunRecord run = sample_survey::good(n);
    run.measurement->set("radius_ratio_min", 0.01 * static_cast<double>(n));
    run.measurement->set("angle_max", 60.0 + static_cast<double>(n));
    results.records.push_back(run);
  }
  const Table table = distribution_table(arrange_runs(results));
  const auto ratio = [&](const char* column) { return cell(table, {"Smallest radius ratio", "good"}, column); };
  EXPECT_EQ(ratio("worst 5 %"), "0.0500");
  EXPECT_EQ(ratio("worse quartile"), "0.250");
  EXPECT_EQ(ratio("median"), "0.500");
  EXPECT_EQ(ratio("best"), "1.00");
  const auto angle = [&](const char* column) { return cell(table, {"Largest angle, °", "good"}, column); };
  EXPECT_EQ(angle("worst"), "160.0");
  EXPECT_EQ(angle("worst 5 %"), "155.0");
  EXPECT_EQ(angle("better quartile"), "85.0");
  EXPECT_EQ(angle("best"), "60.0");
}

TEST(SurveyTables, RanksSayWhatDiffersSignificantly) {
  const Table table = rank_table(arrange_runs(sample_survey::results(60)));
  EXPECT_EQ(cell(table, {"Smallest radius ratio", "good"}, "average rank"), "1.00");
  EXPECT_EQ(cell(table, {"Smallest radius ratio", "good"}, "significantly better than"), "slow, fast");
  EXPECT_EQ(cell(table, {"Seconds per 1,000 vertices", "good"}, "significantly better than"), "slow");
  EXPECT_TRUE(std::any_of(table.remarks.begin(), table.remarks.end(), [](const std::string& remark) {
    return remark.starts_with("Smallest radius ratio: 3 methods on 60 data sets, Friedman χ² = ");
  }));
  // Nobody to compare with.
  Results alone;
  for (std::size_t n = 0; n < 20; ++n) alone.records.push_back(sample_survey::good(n));
  EXPECT_TRUE(rank_table(arrange_runs(alone)).empty());
  EXPECT_FALSE(reliability_table(arrange_runs(alone)).empty());
}

TEST(SurveyTables, StandBeforeTheTablesOfSingleDataSets) {
  const Results results = sample_survey::results(30);
  const std::vector<Table> tables = all_tables(results);
  EXPECT_EQ(tables.front().title, "Reliability");
  const auto first_detail = std::find_if(tables.begin(), tables.end(), [](const Table& table) { return table.detail; });
  const RunGrid runs = arrange_runs(results);
  const std::size_t overview = survey_tables(runs).size() + use_tables(results, runs).size();
  EXPECT_EQ(first_detail - tables.begin(), static_cast<std::ptrdiff_t>(overview));
  for (const Table& table : tables) EXPECT_LT(table.header.size(), 20U) << table.title;  // no column for each data set
  const std::string text = markdown_tables(results);
  EXPECT_LT(text.find("## Reliability"), text.find("## Each data set"));
  EXPECT_NE(text.find("| islands-0019"), std::string::npos);
}

TEST(SurveyTables, FewDataSetsHaveNone) {
  const Results results = sample_survey::results(many_datasets - 1);
  for (const Table& table : all_tables(results)) {
    EXPECT_FALSE(table.detail) << table.title;
    EXPECT_NE(table.title, "Reliability");
  }
}

TEST(SurveyTables, LatexHasTheOverviewAndMacrosOverAllDataSets) {
  const Results results = sample_survey::results(60);
  const std::string text = latex_tables(results);
  EXPECT_NE(text.find("\\caption{Reliability}"), std::string::npos);
  EXPECT_EQ(text.find("\\caption{Each data set}"), std::string::npos);
  EXPECT_NE(text.find("see tables.md"), std::string::npos);
  EXPECT_NE(text.find("\\newcommand{\\isobenchAllGoodRadiusRatioMinSmallest}"), std::string::npos);
  EXPECT_EQ(text.find("isobenchIslands"), std::string::npos);
  EXPECT_LT(text.size(), 200000U);
}

TEST(SurveyTables, TheBestLineNamesEachMethodOnce) {
  Results results = sample_survey::results(60);
  // Nobody is best where nobody else ran.
  for (std::size_t n = 60; n < 90; ++n) results.records.push_back(sample_survey::fast(n));
  const std::string line = best_line(arrange_runs(results));
  EXPECT_TRUE(line.starts_with("Best on the most data sets – good: worst triangle, ")) << line;
  EXPECT_LT(line.find("fast: "), line.find(", time")) << line;
  EXPECT_EQ(count_of(line, "good: "), 1U);
}

}  // namespace
}  // namespace isobench
