#include "isobench/reports/plots/plots.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <numeric>

#include "isobench/foundation/processes/child_process.h"
#include "isobench/foundation/testing/test_folder.h"
#include "isobench/foundation/testing/test_text.h"
#include "isobench/foundation/testing/test_variable.h"
#include "isobench/reports/plots/gnuplot.h"
#include "isobench/reports/record/sample_records.h"

namespace isobench {
namespace {

// Two data sets, two methods; one of the four runs has no mesh.
Results results_for_plots() {
  Results results;
  results.name = "test";
  results.title = "A test";
  results.records = {sample_record("pelvis", "ours"), sample_record("pelvis", "theirs"), sample_record("skull", "ours"),
                     sample_record("skull", "theirs")};
  results.records[1].measurement->histogram("radius_ratio").add(0.75);
  results.records[1].measurement->histogram("radius_ratio").add(0.751);
  results.records[3].status = Status::timeout;
  results.records[3].measurement.reset();
  return results;
}

TEST(Plots, RadiusRatiosOfAllMethodsAreInOnePlot) {
  const Results results = results_for_plots();
  const std::vector<Plot> plots = radius_ratio_plots(arrange_runs(results));
  ASSERT_EQ(plots.size(), 2U);
  ASSERT_EQ(plots[0].series.size(), 2U);
  EXPECT_EQ(plots[0].series[1].name, "theirs");
  ASSERT_EQ(plots[1].series.size(), 1U);  // no mesh, no histogram
  const Series& theirs = plots[0].series[1];
  ASSERT_EQ(theirs.x.size(), 100U);
  EXPECT_DOUBLE_EQ(theirs.x[25], 0.255);  // the middle of the bin from 0.25 to 0.26
  EXPECT_DOUBLE_EQ(theirs.y[25], 100.0 / 3.0);
  EXPECT_DOUBLE_EQ(theirs.y[75], 200.0 / 3.0);
  EXPECT_NEAR(std::accumulate(theirs.y.begin(), theirs.y.end(), 0.0), 100.0, 1e-9);
}

TEST(Plots, ALabelKeepsItsColour) {
  Results results = results_for_plots();
  std::swap(results.records[3].status, results.records[0].status);
  results.records[3].measurement = results.records[1].measurement;
  results.records[0].measurement.reset();
  const std::vector<Plot> plots = radius_ratio_plots(arrange_runs(results));
  ASSERT_EQ(plots[0].series.size(), 1U);
  EXPECT_EQ(plots[0].series[0].name, "theirs");
  EXPECT_EQ(plots[0].series[0].colour, plots[1].series[1].colour);
}

TEST(Plots, RunsOfSeveralSeedsAreOneSeries) {
  Results results;
  results.records = {sample_record("skull", "ours"), sample_record("skull", "ours"), sample_record("skull", "ours")};
  for (std::size_t n = 0; n < 3; ++n) results.records[n].request.seed = n + 1;
  results.records[1].measurement->histogram("radius_ratio").add(0.75);
  // A mesh that is not closed stays out while there are others.
  results.records[2].measurement->set("boundary_edges", 3);
  results.records[2].measurement->histogram("radius_ratio").add(0.05);
  const std::vector<Plot> plots = radius_ratio_plots(arrange_runs(results));
  ASSERT_EQ(plots.size(), 1U);
  ASSERT_EQ(plots[0].series.size(), 1U);
  EXPECT_DOUBLE_EQ(plots[0].series[0].y[25], 200.0 / 3.0);
  EXPECT_DOUBLE_EQ(plots[0].series[0].y[5], 0.0);
}

TEST(Plots, ValencesBeyondTheEndsAreInTheOutermostBars) {
  Results results = results_for_plots();
  results.records[0].measurement->histogram("valence").counts = {0, 1, 0, 1, 0, 0, 4, 0, 0, 0, 0, 0, 2};
  const Plot plot = valence_plots(arrange_runs(results)).front();
  EXPECT_EQ(plot.categories.front(), "≤ 3");
  EXPECT_EQ(plot.categories.back(), "≥ 10");
  EXPECT_EQ(plot.series[0].y, (std::vector<double>{25.0, 0.0, 0.0, 50.0, 0.0, 0.0, 0.0, 25.0}));
}

TEST(Plots, StagesAddUpToTheSecondsOfTheRun) {
  Results results = results_for_plots();
  results.records[0].stages = {
      {"mesh", 5.25, 9.5}, {"mesh/sizing", 2.0, 3.0}, {"mesh/sizing/limit", 1.5, 2.0}, {"mesh/relaxation", 3.0, 4.0}};
  const Plot plot = stage_plots(arrange_runs(results)).front();
  ASSERT_EQ(plot.categories, (std::vector<std::string>{"ours", "theirs"}));
  ASSERT_EQ(plot.series.size(), 3U);
  EXPECT_EQ(plot.series[0].name, "sizing");
  EXPECT_EQ(plot.series[1].name, "relaxation");
  EXPECT_EQ(plot.series[2].name, "rest");
  EXPECT_DOUBLE_EQ(plot.series[0].y[0] + plot.series[1].y[0] + plot.series[2].y[0], 5.25);
  EXPECT_DOUBLE_EQ(plot.series[2].y[0], 0.25);
  EXPECT_DOUBLE_EQ(plot.series[2].y[1], 3.25);  // of its stages only sizing has its own series
}

TEST(Plots, EveryTraceHasItsPlot) {
  Results results = results_for_plots();
  results.records[1].traces = {{"energy", {9.0, 8.0}}, {"moves", {1.0}}};
  const std::vector<Plot> plots = trace_plots(arrange_runs(results));
  ASSERT_EQ(plots.size(), 3U);
  EXPECT_EQ(plots[0].series.size(), 2U);
  EXPECT_EQ(plots[0].series[1].x, (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(plots[1].y_label, "moves");
}

TEST(Plots, NamesAreFitForFilesAndUnique) {
  Results results = results_for_plots();
  for (RunRecord& record : results.records) record.request.dataset = "../a b/" + record.request.dataset;
  std::vector<std::string> names;
  for (const Plot& plot : all_plots(results)) names.push_back(plot.name);
  for (const std::string& name : names) {
    EXPECT_EQ(name.find_first_of("/ "), std::string::npos) << name;
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  }
}

TEST(Plots, AreDrawnWithAllTheirMarks) {
  if (!has_program("gnuplot")) GTEST_SKIP() << "gnuplot is not installed (package gnuplot-nox)";
  const TestFolder folder;
  Results results = results_for_plots();
  results.records[0].request.label = "<ours> & 100 %_^{x}";
  const std::vector<Plot> plots = all_plots(results);
  write_text(folder.path() / "left-over.svg", "of an earlier report");
  const Drawn drawn = draw(plots, folder.path());
  EXPECT_EQ(drawn.missing, "");
  ASSERT_EQ(drawn.names.size(), plots.size());
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "left-over.svg"));
  for (const Plot& plot : plots) {
    const std::string svg = read_text(folder.path() / (plot.name + ".svg"));
    EXPECT_EQ(count_of(svg, "<g id=\"gnuplot_plot_"), plot.series.size()) << plot.name;
    EXPECT_NE(svg.find("viewBox=\"0 0 720 "), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos) << plot.name;
  }
  const std::string ratios = read_text(folder.path() / "radius-ratio-pelvis.svg");
  EXPECT_NE(ratios.find("&lt;ours> &amp; 100 %_^{x}"), std::string::npos);
  EXPECT_NE(ratios.find("% of the triangles in each bin of 0.01"), std::string::npos);
}

TEST(Plots, OfTheSameNumbersAreLeftAsTheyAre) {
  if (!has_program("gnuplot")) GTEST_SKIP() << "gnuplot is not installed (package gnuplot-nox)";
  const TestFolder folder;
  Results results = results_for_plots();
  draw(all_plots(results), folder.path());
  const std::filesystem::path first = folder.path() / "radius-ratio-pelvis.svg";
  const std::string before = read_text(first);
  const auto written = std::filesystem::last_write_time(first);
  draw(all_plots(results), folder.path());
  EXPECT_EQ(std::filesystem::last_write_time(first), written);
  results.records[0].measurement->histogram("radius_ratio").add(0.5);
  draw(all_plots(results), folder.path());
  EXPECT_NE(read_text(first), before);
}

TEST(Plots, WithoutGnuplotTheScriptsAreThereAndTheRemedy) {
  const TestFolder folder;
  const TestVariable path("PATH", folder.path().string());
  const Drawn drawn = draw(all_plots(results_for_plots()), folder.path());
  EXPECT_TRUE(drawn.names.empty());
  EXPECT_NE(drawn.missing.find("apt-get install gnuplot-nox"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "radius-ratio-pelvis.gp"));
}

}  // namespace
}  // namespace isobench
