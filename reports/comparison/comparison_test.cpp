#include "isobench/reports/comparison/comparison.h"

#include <gtest/gtest.h>

#include <limits>

#include "isobench/reports/record/sample_records.h"

namespace isobench {
namespace {

Results two_runs() {
  Results results;
  results.name = "test";
  results.records = {sample_record("pelvis", "particles"), sample_record("skull", "particles")};
  for (RunRecord& record : results.records) record.request.run += "-e0.5-d0.3-s1-0123abcd";
  return results;
}

// The only difference. Fails if there is none or more than one.
Difference only(const Comparison& comparison) {
  EXPECT_EQ(comparison.differences.size(), 1U);
  return comparison.differences.empty() ? Difference{} : comparison.differences.front();
}

TEST(Compare, SecondsMemoryAndCircumstancesAreNoDifference) {
  const Results a = two_runs();
  Results b = two_runs();
  for (RunRecord& record : b.records) {
    record.seconds_total = 8.0;
    record.seconds_method = 6.0;
    record.peak_memory_mb = 400.0;
    record.stages[0].wall_seconds = 8.0;
    record.started = "2027-01-02T03:04:05Z";
    record.environment.commit = "fedcba";
    record.environment.libraries = LibraryVersions{{"VTK", "9.2.0"}};
    record.environment.load = 3.0;
    record.notes = {"read from elsewhere"};
    record.dataset->source = "elsewhere";
    record.request.label = "renamed";
    record.request.aside = true;
    record.request.limit_minutes = 30.0;
  }
  const Comparison comparison = compare(a, b);
  EXPECT_TRUE(comparison.same());
  EXPECT_EQ(comparison.matched, 2U);
  EXPECT_EQ(
      comparison_text(comparison),
      "2 runs are the same on both sides, except for seconds and memory (other circumstances: aside, commit, dataset "
      "source, label, libraries/VTK, limit_minutes, notes; -v shows them).\n");
  const std::string full = comparison_text(comparison, Detail::full);
  EXPECT_NE(full.find("| 5.25   | 8.00   | 1.52  | 321"), std::string::npos) << full;
  EXPECT_NE(full.find("| commit         | abcdef"), std::string::npos) << full;
}

TEST(Compare, EveryFigureCounts) {
  const Results a = two_runs();
  const auto changed = [&a](auto&& change) {
    Results b = two_runs();
    change(b.records[1]);
    return only(compare(a, b)).figure;
  };
  EXPECT_EQ(changed([](RunRecord& r) {
              r.measurement->set("radius_ratio_min", r.measurement->number("radius_ratio_min") + 1e-16);
            }),
            "radius_ratio_min");
  EXPECT_EQ(changed([](RunRecord& r) { r.measurement->set("euler", -13); }), "euler");
  EXPECT_EQ(changed([](RunRecord& r) { r.measurement->histogram("valence").counts[5] = 6; }),
            "histogram valence/counts");
  EXPECT_EQ(changed([](RunRecord& r) { r.measurement->histogram("radius_ratio").add(0.75); }),
            "histogram radius_ratio/counts");
  EXPECT_EQ(changed([](RunRecord& r) { r.counters = {{"particles/splits", 8.0}}; }), "counter particles/splits");
  EXPECT_EQ(changed([](RunRecord& r) { r.traces["energy"][2] = 1.25; }), "trace energy");
  EXPECT_EQ(changed([](RunRecord& r) { r.traces.clear(); }), "trace energy");
  EXPECT_EQ(changed([](RunRecord& r) { r.mesh_checksum = "another"; }), "mesh_checksum");
  EXPECT_EQ(changed([](RunRecord& r) { r.sizing->largest = 5.0; }), "sizing largest");
  EXPECT_EQ(changed([](RunRecord& r) { r.dataset->isovalue = 0.75; }), "dataset isovalue");
  EXPECT_EQ(changed([](RunRecord& r) { r.dataset->lattice.direction(0, 0) = 0.5; }), "dataset direction/0");
  EXPECT_EQ(changed([](RunRecord& r) { set_parameter(r.request, "sweeps", 61.0); }), "request parameters/sweeps");
  EXPECT_EQ(
      changed([](RunRecord& r) { r.measurement->set("edge_over_h0_max", std::numeric_limits<double>::quiet_NaN()); }),
      "edge_over_h0_max");
}

TEST(Compare, ARecordOfBeforeThereWereChecksumsIsNoDifference) {
  Results old = two_runs();
  for (RunRecord& record : old.records) record.mesh_checksum.clear();
  EXPECT_TRUE(compare(old, two_runs()).same());
}

TEST(Compare, FiguresThatAnOlderRecordDoesNotKnowAreNoDifference) {
  Results old = two_runs();
  for (RunRecord& record : old.records) {
    for (const char* later : {"area", "volume"}) record.measurement->set_unknown(figure_index(later));
  }
  EXPECT_TRUE(compare(old, two_runs()).same());
  EXPECT_EQ(comparison_text(compare(old, two_runs())),
            "2 runs are the same on both sides, except for seconds and memory.\n"
            "A has no area, volume: its records are older than these figures. They are not compared.\n");
  EXPECT_NE(comparison_text(compare(two_runs(), old), Detail::full).find("\nB has no area, volume: "),
            std::string::npos);
  EXPECT_EQ(comparison_text(compare(old, old)), "2 runs are the same on both sides, except for seconds and memory.\n");
  // But a figure that one side could not measure is a difference.
  Results open = two_runs();
  open.records[1].measurement->set("volume", std::nullopt);
  EXPECT_EQ(only(compare(open, two_runs())).figure, "volume");
  EXPECT_EQ(only(compare(open, two_runs())).a, "–");
}

TEST(Compare, FiguresThatOneSideDidNotAskForAreNoDifference) {
  Results without = two_runs();
  for (RunRecord& record : without.records) {
    for (const char* figure : {"step_factor", "volume"}) record.measurement->set_unknown(figure_index(figure));
  }
  Results with = two_runs();
  for (RunRecord& record : with.records) record.request.metrics_of_use = true;
  EXPECT_TRUE(compare(without, with).same());
  EXPECT_EQ(comparison_text(compare(without, with)),
            "2 runs are the same on both sides, except for seconds and memory (other circumstances: metrics_of_use; -v "
            "shows them).\n"
            "A has no volume: its records are older than this figure. It is not compared.\n"
            "A has no step_factor: its runs were made without metrics_of_use. It is not compared.\n");
}

TEST(Compare, NoToleranceExcusesAnotherTopology) {
  const Results a = two_runs();
  Results b = two_runs();
  b.records[0].measurement->set("euler", -13);
  b.records[0].measurement->set("vertices", 1003);
  EXPECT_EQ(only(compare(a, b, 0.5)).figure, "euler");
}

TEST(Compare, ToleranceIsRelativeToTheLargerNumber) {
  const Results a = two_runs();
  Results b = two_runs();
  b.records[0].measurement->set("edge_over_h0_max", 1.0);  // 1.25 in a: 20 % of the larger
  b.records[0].traces["energy"] = {3.0, 1.6, 1.5};
  EXPECT_EQ(compare(a, b).differences.size(), 2U);
  EXPECT_DOUBLE_EQ(compare(a, b).differences[0].relative, 0.2);
  EXPECT_EQ(compare(a, b, 0.19).differences.size(), 2U);
  EXPECT_TRUE(compare(a, b, 0.21).same());
  // A number and NaN differ under any tolerance.
  b.records[0].measurement->set("edge_over_h0_max", std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(compare(a, b, 1.0).differences.size(), 1U);
  EXPECT_EQ(compare(b, b, 0.0).differences.size(), 0U);
}

TEST(Compare, AnotherStatusIsADifferenceWithItsReason) {
  const Results a = two_runs();
  Results b = two_runs();
  b.records[1].status = Status::timeout;
  b.records[1].reason = "not finished after 20 minutes";
  b.records[1].measurement.reset();
  const std::string text = comparison_text(compare(a, b));
  EXPECT_NE(text.find("1 of 2 runs in both differ."), std::string::npos) << text;
  EXPECT_NE(text.find("| status "), std::string::npos) << text;
  EXPECT_NE(text.find("not finished after 20 minutes"), std::string::npos) << text;
}

TEST(Compare, RunsOfOneSideSayWhy) {
  Results a = two_runs();
  Results b = two_runs();
  b.records.pop_back();
  a.records[0].request.run = "pelvis-particles-e0.5-d0.3-s1-ffffffff";
  a.records[0].request.method_revision = 7;
  b.missing = {a.records[1].request, sample_record("vessel", "particles").request};
  a.missing = {b.missing[1]};
  const Comparison comparison = compare(a, b);
  EXPECT_FALSE(comparison.same());
  EXPECT_EQ(comparison.matched, 0U);
  EXPECT_EQ(comparison.undone, 1U);
  ASSERT_EQ(comparison.only_a.size(), 2U);
  ASSERT_EQ(comparison.only_b.size(), 1U);
  EXPECT_EQ(comparison.only_a[0].why,
            "pelvis-particles-e0.5-d0.3-s1-0123abcd is there instead; they differ in method_revision: 7 and 1");
  EXPECT_EQ(comparison.only_b[0].why,
            "pelvis-particles-e0.5-d0.3-s1-ffffffff is there instead; they differ in method_revision: 7 and 1");
  EXPECT_EQ(comparison.only_a[1].why, "not done there");
  b.missing[0].run = "skull-particles-e0.5-d0.3-s1-eeeeeeee";
  a.records[1].request.metrics_revision = 4;
  b.missing[0].metrics_revision = 5;
  EXPECT_EQ(
      compare(a, b).only_a[1].why,
      "skull-particles-e0.5-d0.3-s1-eeeeeeee is planned there instead, but not done; they differ in metrics_revision: "
      "4 and 5");
  const std::string text = comparison_text(comparison);
  EXPECT_NE(text.find("No run is in both, 2 runs only in A, 1 run only in B; 1 planned run done on neither side."),
            std::string::npos)
      << text;
}

TEST(Compare, DamagedRecordsAndWhoPromisesNothingAreSaid) {
  const Results a = two_runs();
  Results b = two_runs();
  b.unreadable = {"results/b/x/run.json: not a readable run record"};
  EXPECT_FALSE(compare(a, b).same());
  EXPECT_NE(comparison_text(compare(a, b)).find("x/run.json: not a readable"), std::string::npos);
  Results c = two_runs();
  Results d = two_runs();
  c.records[0].deterministic = d.records[0].deterministic = false;
  d.records[0].measurement->set("vertices", 1003);
  const Comparison comparison = compare(c, d);
  EXPECT_EQ(comparison.not_deterministic, std::vector<std::string>{c.records[0].request.run});
  EXPECT_NE(comparison_text(comparison).find("do not promise the same mesh every time: pelvis"), std::string::npos);
}

}  // namespace
}  // namespace isobench
