#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "isobench/foundation/processes/child_process.h"
#include "isobench/foundation/testing/test_folder.h"
#include "isobench/foundation/testing/test_text.h"
#include "isobench/reports/plots/gnuplot.h"
#include "isobench/reports/plots/plots.h"
#include "isobench/reports/survey/sample_survey.h"

namespace isobench {
namespace {

const Plot& plot_called(const std::vector<Plot>& plots, const std::string& name) {
  static const Plot none;
  const auto found = std::find_if(plots.begin(), plots.end(), [&name](const Plot& plot) { return plot.name == name; });
  if (found == plots.end()) ADD_FAILURE() << "no plot " << name;
  return found == plots.end() ? none : *found;
}

// The y of a curve at its last x that is not above `x`.
double at(const Series& series, double x) {
  const auto after = std::upper_bound(series.x.begin(), series.x.end(), x + 1e-9);
  return series.y.at(static_cast<std::size_t>(after - series.x.begin()) - 1);
}

TEST(SurveyPlots, TheCumulativeShareCountsEveryDataSet) {
  const Results results = sample_survey::results(60);
  const std::vector<Plot> plots = survey_plots(arrange_runs(results));
  const Plot& plot = plot_called(plots, "share-radius-ratio-min");
  ASSERT_EQ(plot.series.size(), 3U);
  EXPECT_EQ(at(plot.series[0], 0.0), 100.0);
  EXPECT_EQ(at(plot.series[0], 0.8), 100.0);
  EXPECT_EQ(at(plot.series[0], 0.9), 0.0);
  EXPECT_EQ(at(plot.series[1], 0.3), 0.0);
  EXPECT_EQ(at(plot.series[2], 0.0), 95.0);  // 3 of 60 data sets have no mesh
  for (const Series& series : plot.series) EXPECT_TRUE(std::is_sorted(series.y.rbegin(), series.y.rend()));
  const Series& angles = plot_called(plots, "share-angle-max").series[0];
  EXPECT_EQ(at(angles, 89.2), 100.0);
  EXPECT_EQ(at(angles, 85.0), 0.0);
}

TEST(SurveyPlots, ProfilesStartAtTheWinsAndEndAtTheSolved) {
  const Results results = sample_survey::results(60);
  const std::vector<Plot> plots = survey_plots(arrange_runs(results));
  const Plot& quality = plot_called(plots, "profile-radius-ratio-min");
  EXPECT_EQ(quality.series[0].y.front(), 100.0);
  EXPECT_EQ(quality.series[2].y.front(), 0.0);
  EXPECT_DOUBLE_EQ(quality.series[2].y.back(), 95.0);
  const Plot& seconds = plot_called(plots, "profile-seconds-per-1000-vertices");
  EXPECT_DOUBLE_EQ(seconds.series[1].y.front(), 90.0);  // the fast one, where it is closed: 54 of 60
  EXPECT_DOUBLE_EQ(seconds.series[1].y.back(), 90.0);
  EXPECT_DOUBLE_EQ(seconds.series[0].y.front(), 10.0);
}

TEST(SurveyPlots, BoxesHaveTheQuartiles) {
  Results results;
  for (std::size_t n = 0; n <= 100; ++n) {
    RunRecord run = sample_survey::good(n);
    run.measurement->set("radius_ratio_min", 0.25 + 0.005 * static_cast<double>(n));
    results.records.push_back(run);
  }
  results.records[50].measurement->set("radius_ratio_min", 0.001);
  const std::vector<Plot> plots = survey_plots(arrange_runs(results));
  const Series& box = plot_called(plots, "boxes-radius-ratio-min").series.at(0);
  ASSERT_EQ(box.range.size(), 5U);
  EXPECT_NEAR(box.range[2], 0.5, 0.006);
  EXPECT_NEAR(box.range[1], 0.375, 0.006);
  EXPECT_EQ(box.range[4], 0.75);
  EXPECT_TRUE(box.x.empty());  // 0.001 is within 1.5 times the length of the box
  const Plot& families = plot_called(plots, "families-radius-ratio-min");
  ASSERT_EQ(families.series.size(), 3U);
  EXPECT_EQ(families.series[1].name, "islands");
  // A single method has no rank, profile or front.
  for (const Plot& plot : plots) EXPECT_TRUE(plot.kind == "boxes" || plot.kind == "share") << plot.name;
}

TEST(SurveyPlots, TheFrontAndTheRanksAreThoseOfTheMethods) {
  const Results results = sample_survey::results(60);
  const std::vector<Plot> plots = survey_plots(arrange_runs(results));
  const Plot& pareto = plot_called(plots, "pareto-radius-ratio-min");
  ASSERT_EQ(pareto.series.size(), 4U);
  EXPECT_EQ(pareto.series[3].name, "Pareto front");
  EXPECT_EQ(pareto.series[3].x, (std::vector<double>{pareto.series[1].x[0], pareto.series[0].x[0]}));  // not "slow"
  const Plot& ranks = plot_called(plots, "ranks-radius-ratio-min");
  ASSERT_EQ(ranks.series.size(), 3U);
  EXPECT_EQ(ranks.series[0].name, "good");
  EXPECT_EQ(ranks.series[0].x, std::vector<double>{1.0});
  EXPECT_NEAR(ranks.series[0].range[1] - ranks.series[0].range[0], 2.343 * std::sqrt(3.0 * 4.0 / 360.0), 1e-3);
}

TEST(SurveyPlots, ManyDataSetsHaveNoPlotsOfSingleOnes) {
  const Results results = sample_survey::results(800);
  std::size_t numbers = 0;
  for (const Plot& plot : all_plots(results)) {
    EXPECT_EQ(plot.name.find("0001"), std::string::npos) << plot.name;
    for (const Series& series : plot.series) numbers += series.x.size();
  }
  EXPECT_LT(numbers, 30000U);
  const Plot histogram = radius_ratio_plots(arrange_runs(results)).at(0);
  EXPECT_EQ(histogram.title, "Radius ratios of the triangles, all data sets");
  EXPECT_EQ(radius_ratio_plots(arrange_runs(results)).size(), 1U);
  const Plot points = size_plots(arrange_runs(results)).front();
  EXPECT_NE(points.caption.find("Of every 2 data sets only the first is shown"), std::string::npos) << points.caption;
}

TEST(SurveyPlots, AreDrawn) {
  if (!has_program("gnuplot")) GTEST_SKIP() << "gnuplot is not installed (package gnuplot-nox)";
  const TestFolder folder;
  const std::vector<Plot> plots = survey_plots(arrange_runs(sample_survey::results(60)));
  const Drawn drawn = draw(plots, folder.path());
  EXPECT_EQ(drawn.missing, "");
  ASSERT_EQ(drawn.names.size(), plots.size());
  for (const Plot& plot : plots) {
    const std::string svg = read_text(folder.path() / (plot.name + ".svg"));
    EXPECT_EQ(svg.find("nan"), std::string::npos) << plot.name;
    // Every series is named, in the legend or beside its row.
    for (const Series& series : plot.series) EXPECT_NE(svg.find(">" + series.name), std::string::npos) << plot.name;
  }
}

}  // namespace
}  // namespace isobench
