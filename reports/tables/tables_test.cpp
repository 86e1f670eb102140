#include "isobench/reports/tables/tables.h"

#include <gtest/gtest.h>

#include <sstream>

#include "isobench/reports/record/sample_records.h"
#include "isobench/reports/runs/timing.h"
#include "isobench/reports/tables/best_methods.h"
#include "isobench/reports/tables/summary.h"
#include "isobench/reports/tables_document.h"
#include "isobench/reports/text/markdown.h"

namespace isobench {
namespace {

// The cells of the first table row in a Markdown text that starts with these cells.
std::vector<std::string> find_row(const std::string& text, const std::vector<std::string>& start) {
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with("| ")) continue;
    std::vector<std::string> cells;
    std::istringstream parts(line.substr(1));
    for (std::string cell; std::getline(parts, cell, '|');) {
      const std::size_t first = cell.find_first_not_of(' ');
      const std::size_t last = cell.find_last_not_of(' ');
      cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
    }
    if (cells.size() >= start.size() && std::equal(start.begin(), start.end(), cells.begin())) return cells;
  }
  ADD_FAILURE() << "no row " << start.front() << " in\n" << text;
  return std::vector<std::string>(20);
}

std::vector<std::string> find_row(const Table& table, const std::vector<std::string>& start) {
  return find_row(markdown(table), start);
}

Results results_for_tables() {
  Results results;
  results.name = "test";
  results.title = "A test";
  results.records = {sample_record("pelvis", "particles"), sample_record("pelvis", "marching-cubes"),
                     sample_record("skull", "particles"), sample_record("skull", "marching-cubes")};
  results.records[2].measurement->set("nonmanifold_vertices", 2);
  results.records[2].measurement->set("nonmanifold_edges", 1);
  results.records[3].status = Status::timeout;
  results.records[3].reason = "not finished after 20 minutes";
  results.records[3].measurement.reset();
  results.published = read_published(ISOBENCH_SOURCE "/experiments/published/meyer-2007.toml");
  return results;
}

TEST(Tables, StagesOfAMethodStandInTheOrderInWhichTheyEnded) {
  Results results = results_for_tables();
  // The sample has only one stage besides "mesh". Stages within others and stages of measuring have no column.
  EXPECT_TRUE(stage_tables(arrange_runs(results)).empty());
  results.records[0].stages = {{"prepare", 9.0, 9.0},    {"mesh/sizing", 0.5, 1.0}, {"mesh/seeds/inner", 0.75, 1.0},
                               {"mesh/seeds", 1.0, 1.5}, {"mesh", 2.0, 3.0},        {"measure/shape", 0.5, 0.5}};
  results.records[0].measurement->set("vertices", 1000);
  const auto tables = stage_tables(arrange_runs(results));
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables[0].title, "Seconds by stage: particles");
  EXPECT_EQ(tables[0].header, (std::vector<std::string>{"Data", "Method", "vertices", "sizing", "seeds", "total",
                                                        "CPU / wall", "µs per vertex"}));
  const auto row = find_row(tables[0], {"pelvis", "particles"});
  EXPECT_EQ(row, (std::vector<std::string>{"pelvis", "particles", "1000", "0.500", "1.00", "2.00", "1.50", "2000"}));
  // A run without a stage shows a dash, not zero seconds.
  EXPECT_EQ(find_row(tables[0], {"skull", "particles †"})[4], "–");
}

TEST(Tables, RadiusRatiosAreOursBesideThePublished) {
  const Results results = results_for_tables();
  const std::string table = markdown(radius_ratio_table(results, arrange_runs(results)));
  const auto particles = find_row(table, {"particles"});
  EXPECT_EQ(particles[1], "0.300 / 0.945 (published 0.40 / 0.92)");
  EXPECT_EQ(particles[2], "0.300 / 0.945 † (published 0.092 / 0.94)");
  const auto cubes = find_row(table, {"marching-cubes"});
  EXPECT_EQ(cubes[1], "0.300 / 0.945 (published 0.00 / 0.66)");
  EXPECT_EQ(cubes[2], "timeout: not finished after 20 minutes (published 0.000 / 0.66)");
  // Published without a run of ours beside it.
  const auto front = find_row(table, {"advancing-front (published: af)"});
  EXPECT_EQ(front[1], "published 0.23 / 0.94");
  EXPECT_NE(table.find("2 r_in / r_circ"), std::string::npos);  // its definition in words
  EXPECT_NE(table.find("Published: Meyer, Kirby, Whitaker 2007, Table 2, measured on other data than ours"),
            std::string::npos);
  const std::string all = markdown_tables(results);
  EXPECT_NE(all.find("IEEE Transactions on Visualization and Computer Graphics"), std::string::npos);
  EXPECT_NE(all.find("stand-ins"), std::string::npos);
}

TEST(Tables, SizesSayWhatTheyAreOf) {
  const Results results = results_for_tables();
  const auto row = find_row(sizes_table(results, arrange_runs(results)), {"pelvis", "particles"});
  EXPECT_EQ(row[2], "64 × 32 × 16 (published 271 × 390 × 282 voxels)");
  EXPECT_EQ(row[3], "0.5, 0.3 (published 0.75, 0.5)");
  EXPECT_EQ(row[4], "5.25 s (published 1 min)");
  EXPECT_EQ(row[5], "1002 (published 4992)");
  EXPECT_EQ(row[6], "2000 (published 9984)");
}

TEST(Tables, ValencesHaveTheirAverages) {
  Results results = results_for_tables();
  results.records[2].measurement->set("valence_6_percent", 66.0);
  const Table table = valence_table(results, arrange_runs(results));
  EXPECT_EQ(find_row(table, {"pelvis", "particles"})[4], "64.00");
  // The skull's mesh is no closed manifold.
  EXPECT_EQ(find_row(table, {"average of 1, 1 † left out", "particles"})[4], "64.00");
  EXPECT_EQ(find_row(table, {"average", "published: ps"})[4], "63.275");
  EXPECT_NE(find_row(table, {"average", "published: ps"})[6].find("0.7"), std::string::npos);
  EXPECT_EQ(find_row(table, {"skull", "marching-cubes"})[2], "timeout: not finished after 20 minutes");
}

TEST(Tables, TopologyCountsPinchesAndMarksThem) {
  const Results results = results_for_tables();
  const Table table = topology_table(arrange_runs(results));
  const auto whole = find_row(table, {"pelvis", "particles"});
  const auto pinched = find_row(table, {"skull", "particles †"});
  EXPECT_EQ(whole[2], "1");
  EXPECT_EQ(whole[3], "3");
  EXPECT_EQ(whole[4], "-14");
  EXPECT_EQ(whole[5], "-12");
  EXPECT_EQ(whole[7], "0");
  EXPECT_EQ(pinched[7], "3");
  const std::string all = markdown_tables(results);
  EXPECT_NE(all.find("† The mesh is not a closed manifold"), std::string::npos);
}

TEST(Tables, ATopologyIsRightOrWrongOnlyBesideOneThatIsProven) {
  Results results = results_for_tables();
  const auto right = [&results] { return find_row(methods_table(arrange_runs(results)), {"particles"})[3]; };
  EXPECT_EQ(right(), "0 of 2");
  Measurement& pelvis = *results.records[0].measurement;
  pelvis.set("euler_reference", pelvis.figure("euler"));
  pelvis.set("components_reference", pelvis.figure("components"));
  EXPECT_EQ(right(), "1 of 2");
  const auto forget = [](Measurement& measurement) {
    for (const char* figure : {"euler_reference", "components_reference"}) measurement.set(figure, std::nullopt);
  };
  forget(*results.records[2].measurement);
  EXPECT_EQ(right(), "1 of 1");
  forget(pelvis);
  EXPECT_EQ(right(), "–");
  EXPECT_EQ(find_row(topology_table(arrange_runs(results)), {"pelvis", "particles"})[5], "–");
}

TEST(Summary, SaysWhyTheSurfaceHasNoTopology) {
  Measurement measurement = *sample_record("skull", "particles").measurement;
  EXPECT_NE(summary_text(measurement).find("components 1 (surface 3), Euler -14 (surface -12)\n"), std::string::npos);
  measurement.set("euler_reference", std::nullopt);
  const std::string open = summary_text(measurement);
  EXPECT_NE(open.find("components 1, Euler -14 (surface not measured: the surface leaves the volume"),
            std::string::npos)
      << open;
  EXPECT_NE(open.find("distance      mean 0.0125 mm"), std::string::npos) << open;
}

TEST(Summary, HasALineForFiguresThatWereAskedFor) {
  Measurement measurement = *sample_record("skull", "particles").measurement;
  measurement.set("step_factor", 12.25);
  measurement.set("step_factor_consistent", 36.5);
  measurement.set("condition", std::nullopt);
  const std::string asked = summary_text(measurement);
  EXPECT_NE(asked.find("time step     factor 12.25, with consistent mass 36.5\n"), std::string::npos) << asked;
  EXPECT_NE(asked.find("condition     not measured: a triangle of the mesh has no area"), std::string::npos) << asked;
  for (const char* figure : {"step_factor", "condition"}) measurement.set_unknown(figure_index(figure));
  const std::string unasked = summary_text(measurement);
  EXPECT_EQ(unasked.find("time step"), std::string::npos) << unasked;
  EXPECT_EQ(unasked.find("condition"), std::string::npos) << unasked;
}

TEST(Tables, EdgesAboveH0ComeWithTheBoundPrinted) {
  Results results = results_for_tables();
  results.records[2].measurement->set("edge_over_own_h0_exceed_triangle_percent", 0.002);
  const auto row = find_row(edge_length_table(results, arrange_runs(results)), {"skull", "particles †"});
  EXPECT_EQ(row[2], "1.250");
  EXPECT_EQ(row[3], "3");
  EXPECT_EQ(row[5], "0.00350");
  EXPECT_EQ(row[6], "0.00200 (published < 0.004 %)");
}

TEST(Tables, CostIsInSeconds) {
  const Results results = results_for_tables();
  const auto row = find_row(cost_table(arrange_runs(results)), {"pelvis", "particles"});
  EXPECT_EQ((std::vector<std::string>(row.begin() + 2, row.begin() + 7)),
            (std::vector<std::string>{"1.50", "2.00", "3.25", "5.25", "321"}));
}

TEST(Tables, SecondsAreComparedAmongRunsThatWereTimedAlike) {
  Results results = results_for_tables();
  for (RunRecord& record : results.records) {
    record.environment.cpu = "slow";
    record.environment.cores = 4;
  }
  EXPECT_EQ(timing_remark(arrange_runs(results)), "");
  // On another, faster machine.
  results.records[1].environment.cpu = "fast";
  results.records[1].environment.exclusive = true;
  results.records[1].seconds_total = 0.125;
  const RunGrid runs = arrange_runs(results);
  const auto row = find_row(cost_table(runs), {"pelvis", "marching-cubes"});
  EXPECT_EQ((std::vector<std::string>(row.begin() + 2, row.begin() + 7)),
            (std::vector<std::string>{"§", "§", "§", "§", "321"}));
  EXPECT_EQ(find_row(cost_table(runs), {"pelvis", "particles"})[5], "5.25");
  EXPECT_EQ(find_row(best_table(runs), {"Time for sizing and method"})[1], "particles: 5.25 s");
  EXPECT_EQ(find_row(methods_table(runs), {"marching-cubes"})[8], "§");
  const std::string remark =
      "§ Seconds are compared only between runs on slow, 4 cores, 2 threads. Left out: 1 run on fast, 4 cores, 2 "
      "threads, nothing else on the machine.";
  EXPECT_EQ(timing_remark(runs), remark);
  for (const Table& table : {cost_table(runs), sizes_table(results, runs), best_table(runs), methods_table(runs)}) {
    EXPECT_EQ(table.remarks.empty() ? "" : table.remarks.back(), remark) << table.title;
  }
}

TEST(Tables, WhatIsMissingIsSaid) {
  Results results = results_for_tables();
  results.missing.push_back(sample_record("vessel", "particles").request);
  results.unreadable.push_back("results/x/run.json: not a readable run record");
  const std::string text = markdown_tables(results);
  EXPECT_NE(text.find("1 of 5 runs are not done yet: vessel-particles"), std::string::npos);
  EXPECT_NE(text.find("not a readable run record"), std::string::npos);
  // Of very many runs, only the first 20 are named.
  results.missing.resize(1000, results.missing.front());
  EXPECT_NE(markdown_tables(results).find(" vessel-particles and 980 more\n"), std::string::npos);
}

TEST(Tables, SeveralSizingsAreToldApartAndSeedsAreTheirSpread) {
  Results results;
  for (const double epsilon : {0.5, 0.75}) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      results.records.push_back(sample_record("skull", "particles"));
      results.records.back().request.sizing.epsilon = epsilon;
      results.records.back().request.seed = seed;
      results.records.back().measurement->set("vertices", 1000 + 100 * seed * seed);
      results.records.back().seconds_total = 1.0 / static_cast<double>(seed);
    }
  }
  const RunGrid runs = arrange_runs(results);
  ASSERT_EQ(runs.variants.size(), 2U);
  EXPECT_EQ(runs.variants[1].name, "particles, ε 0.75, δ 0.3");
  const auto spread = find_row(seed_table(runs), {"skull", "particles, ε 0.5, δ 0.3 (3 seeds)"});
  EXPECT_EQ(spread[2], "1400 (1100–1900)");
  EXPECT_EQ(spread[6], "0.500 (0.333–1.00)");
  EXPECT_EQ(spread[7], "–");  // no seed was repeated
  const auto sizes = find_row(sizes_table(results, runs), {"skull", "particles, ε 0.75, δ 0.3 (3 seeds)"});
  EXPECT_EQ(sizes[4], "0.500 (0.333–1.00) s");
  EXPECT_EQ(sizes[5], "1400 (1100–1900)");
  EXPECT_EQ(sizes[6], "2000");  // where all agree, one value
  EXPECT_NE(markdown_tables(results).find("the median of the finished runs, followed by their range"),
            std::string::npos);
}

TEST(Tables, RepeatsThatDisagreeBreakAPromise) {
  Results results;
  for (const int repeat : {1, 2, 3}) {
    results.records.push_back(sample_record("skull", "particles"));
    results.records.back().request.repeat = repeat;
  }
  EXPECT_EQ(find_row(seed_table(arrange_runs(results)), {"skull", "particles (3 repeats)"})[7], "the same mesh");
  EXPECT_EQ(markdown_tables(results).find("Not deterministic"), std::string::npos);
  results.records[2].mesh_checksum = "another";
  EXPECT_EQ(find_row(seed_table(arrange_runs(results)), {"skull", "particles (3 repeats)"})[7], "2 different meshes");
  EXPECT_NE(markdown_tables(results).find("- particles on skull: 2 different meshes in repeats of one seed"),
            std::string::npos);
  // A method that promises nothing breaks no promise, and another seed may give another mesh.
  for (RunRecord& record : results.records) record.deterministic = false;
  EXPECT_EQ(markdown_tables(results).find("**Not deterministic**"), std::string::npos);
  for (RunRecord& record : results.records) record.deterministic = true;
  results.records[2].request.seed = 2;
  EXPECT_EQ(markdown_tables(results).find("**Not deterministic**"), std::string::npos);
}

TEST(Tables, UnfinishedRunsOfAGroupAreCountedAndLeftOut) {
  Results results;
  for (const std::uint64_t seed : {1, 2, 3}) {
    results.records.push_back(sample_record("skull", "particles"));
    results.records.back().request.seed = seed;
    results.records.back().measurement->set("vertices", 1000 * seed);
  }
  results.records[0].status = Status::timeout;
  results.records[0].measurement.reset();
  results.records[1].measurement->set("boundary_edges", 4);
  const std::string some = "particles (3 seeds, 1 timeout, 1 † left out)";
  EXPECT_EQ(find_row(sizes_table(results, arrange_runs(results)), {"skull", some})[5], "3000");
  EXPECT_EQ(find_row(radius_ratio_table(results, arrange_runs(results)), {"particles"})[1],
            "0.300 / 0.945 (3 seeds, 1 timeout, 1 † left out)");
  // The topology table shows what is wrong with a mesh, so it leaves none out.
  const Table topology = topology_table(arrange_runs(results));
  EXPECT_EQ(find_row(topology, {"skull", "particles (3 seeds, 1 timeout, 1 †)"})[6], "2 (0–4)");
}

TEST(Tables, WhereNoMeshIsAClosedManifoldAllCountAndAreMarked) {
  Results results;
  for (const std::uint64_t seed : {1, 2}) {
    results.records.push_back(sample_record("skull", "particles"));
    results.records.back().request.seed = seed;
    results.records.back().measurement->set("vertices", 1000 * seed);
    results.records.back().measurement->set("nonmanifold_vertices", 1);
  }
  const auto row = find_row(sizes_table(results, arrange_runs(results)), {"skull", "particles (2 seeds)"});
  EXPECT_EQ(row[5], "1500 (1000–2000)");
  EXPECT_EQ(row[6], "2000 †");
}

TEST(Tables, TheAverageOverDataSetsLeavesOutWhatIsNoClosedManifold) {
  Results results;
  const std::vector<double> shares = {60.0, 70.0, 95.0};
  const std::vector<std::string> names = {"brain", "pelvis", "skull"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    results.records.push_back(sample_record(names[i], "particles"));
    results.records.back().measurement->set("valence_6_percent", shares[i]);
  }
  results.records[2].measurement->set("boundary_edges", 4);
  const Table some = valence_table(results, arrange_runs(results));
  EXPECT_EQ(find_row(some, {"average of 2, 1 † left out", "particles"})[4], "65.00");
  for (RunRecord& record : results.records) record.measurement->set("boundary_edges", 4);
  const Table none = valence_table(results, arrange_runs(results));
  EXPECT_EQ(find_row(none, {"average of 3", "particles †"})[4], "75.00");
  for (RunRecord& record : results.records) record.measurement->set("boundary_edges", 0);
  const Table all = valence_table(results, arrange_runs(results));
  EXPECT_EQ(find_row(all, {"average of 3", "particles"})[4], "75.00");
}

TEST(Tables, SayWhatWasMatchedAndWhatCouldNotBe) {
  Results results;
  for (const char* method : {"particles", "cvt", "marching-cubes"}) {
    results.records.push_back(sample_record("skull", method));
    if (results.records.size() > 1) results.records.back().request.match_to = "skull-particles";
  }
  EXPECT_TRUE(match_table({}).empty());
  results.records[1].match = MatchRecord{1000.0, 0.8765, 3, ""};
  results.records[2].match = MatchRecord{1000.0, 1.0, 3, "its number of vertices does not follow the sizing"};
  results.records[2].measurement->set("vertices", 1500);
  const Table matches = match_table(results);
  const auto near = find_row(matches, {"skull", "cvt"});
  EXPECT_EQ(near, (std::vector<std::string>{"skull", "cvt", "particles", "1002", "1000", "0.20", "0.8765", "3"}));
  EXPECT_EQ(find_row(matches, {"skull", "marching-cubes"})[7], "3 ‡ its number of vertices does not follow the sizing");
  EXPECT_EQ(find_row(radius_ratio_table(results, arrange_runs(results)), {"marching-cubes"})[1], "0.300 / 0.945 ‡");
  EXPECT_EQ(find_row(radius_ratio_table(results, arrange_runs(results)), {"cvt"})[1], "0.300 / 0.945");
  EXPECT_NE(markdown_tables(results).find("‡ The mesh does not have the number of vertices"), std::string::npos);
}

TEST(Tables, WithoutPublishedFiguresNothingIsClaimed) {
  Results results = results_for_tables();
  results.published.reset();
  EXPECT_EQ(markdown_tables(results).find("ublished"), std::string::npos);
}

TEST(Markdown, PadsByCharactersAndEscapesBars) {
  MarkdownTable table({"ε", "b"});
  table.add({"x|y", "1"});
  EXPECT_EQ(table.text(), "| ε    | b   |\n| ---- | --- |\n| x\\|y | 1   |\n");
  EXPECT_EQ(significant(0.01953, 3), "0.0195");
  EXPECT_EQ(significant(1234.5, 3), "1234");
  EXPECT_EQ(significant(7.07e-6, 3), "7.07e-06");
  EXPECT_EQ(significant(0.0, 3), "0");
}

}  // namespace
}  // namespace isobench
