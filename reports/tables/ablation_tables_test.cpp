#include <gtest/gtest.h>

#include "isobench/reports/record/sample_records.h"
#include "isobench/reports/tables/tables.h"

namespace isobench {
namespace {

RunRecord changed(const std::string& dataset, const std::string& label, const std::string& parameter,
                  const ParameterValue& value) {
  RunRecord record = sample_record(dataset, "particles", label);
  set_parameter(record.request, parameter, value);
  return record;
}

Results one_at_a_time() {
  Results results;
  results.records = {sample_record("torus", "particles"), changed("torus", "particles sweeps=10", "sweeps", 10.0),
                     changed("torus", "particles finish=false", "finish", false),
                     sample_record("torus", "marching-cubes")};
  return results;
}

std::vector<std::string> texts(const TableRow& row) {
  std::vector<std::string> all;
  for (const TableCell& cell : row) all.push_back(cell.text());
  return all;
}

TEST(AblationTables, ShowWhatEachChangeDoesBesideTheBase) {
  Results results = one_at_a_time();
  Measurement& few = *results.records[1].measurement;
  few.set("radius_ratio_avg", few.number("radius_ratio_avg") - 0.0125);
  few.set("valence_6_percent", few.number("valence_6_percent") + 2.0);
  few.set("nonmanifold_vertices", 3);
  few.set("self_intersections", 1);
  results.records[1].seconds_total = 2.25;
  const auto tables = ablation_tables(arrange_runs(results));
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables[0].title, "Effect of changing one parameter: particles");
  ASSERT_EQ(tables[0].rows.size(), 3U);
  EXPECT_EQ(texts(tables[0].rows[0]), (std::vector<std::string>{"torus", "nothing", "1002", "0.300", "0.9449", "64.0",
                                                                "0.0000", "0.0000", "-14", "0", "5.25"}));
  EXPECT_EQ(texts(tables[0].rows[1]),
            (std::vector<std::string>{"torus", "sweeps = 10 †", "1002", "0.300", "0.9324 [−0.0125]", "66.0 [+2.0]",
                                      "0.0000", "0.0000", "-14", "4 [+4]", "2.25 [−3.00]"}));
  // What does not change has no brackets.
  EXPECT_EQ(texts(tables[0].rows[2])[4], "0.9449");
}

TEST(AblationTables, NeedTwoChangesFromOneBase) {
  Results results = one_at_a_time();
  results.records.erase(results.records.begin() + 2);
  EXPECT_TRUE(ablation_tables(arrange_runs(results)).empty());
  // A variant that differs in two parameters does not count.
  RunRecord both = changed("torus", "particles both", "finish", false);
  set_parameter(both.request, "sweeps", 20.0);
  results.records.push_back(both);
  EXPECT_TRUE(ablation_tables(arrange_runs(results)).empty());
}

TEST(AblationTables, SayWhereAChangeDidNotFinish) {
  Results results = one_at_a_time();
  results.records[2].status = Status::timeout;
  results.records[2].reason = "not finished after 10 minutes";
  results.records[2].measurement.reset();
  const auto tables = ablation_tables(arrange_runs(results));
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables[0].rows[2][2].text(), "timeout: not finished after 10 minutes");
  EXPECT_EQ(tables[0].rows[2][3].text(), "–");
}

}  // namespace
}  // namespace isobench
