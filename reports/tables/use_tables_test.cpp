#include <gtest/gtest.h>

#include <algorithm>

#include "isobench/reports/record/sample_refinement.h"
#include "isobench/reports/tables/tables.h"

namespace isobench {
namespace {

std::vector<Table> tables_of(const std::vector<RunRecord>& records) {
  Results results;
  results.records = records;
  return use_tables(results, arrange_runs(results));
}

std::string cell(const Table& table, std::size_t row, const std::string& column) {
  const auto found = std::find(table.header.begin(), table.header.end(), column);
  EXPECT_NE(found, table.header.end()) << column;
  return table.rows[row][static_cast<std::size_t>(found - table.header.begin())].text();
}

std::vector<RunRecord> two_methods() {
  std::vector<RunRecord> records = sample_levels("sphere", "ours", 0.2, 2.0);
  for (const RunRecord& record : sample_levels("sphere", "theirs", 0.4, 1.5)) {
    records.push_back(record);
    records.back().measurement->set("step_factor", 8.0);
    records.back().measurement->set("condition", 7.0);
  }
  return records;
}

TEST(UseTables, HaveOneLineAMethodOfItsFinestMesh) {
  const std::vector<Table> tables = tables_of(two_methods());
  ASSERT_EQ(tables.size(), 1U);
  const Table& table = tables.front();
  EXPECT_EQ(table.title, "What a simulation pays and gets: sphere");
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0].front().text(), "ours");
  EXPECT_EQ(cell(table, 0, "vertices"), "16000");
  EXPECT_EQ(cell(table, 0, "order, Poisson L2"), "2.00");
  EXPECT_EQ(cell(table, 1, "order, Poisson L2"), "1.50");
  EXPECT_EQ(cell(table, 1, "order, gradient max"), "1.00");
  EXPECT_EQ(cell(table, 0, "meshing s"), "5.25");
}

// On a sphere of radius 1 with 40,000 triangles h² is 7.2552e-4, and with the step factor 12 the largest explicit step
// is 1.2092e-4: until t = 1/4 it takes 2068 steps.
TEST(UseTables, StepsAreThoseOfAnExplicitSchemeUntilAQuarterOfL2) {
  RunRecord record = sample_level("sphere", "ours", 20000, 0.2, 2.0);
  record.measurement->set("area", 12.566370614);
  EXPECT_EQ(cell(tables_of({record}).front(), 0, "steps"), "2068");
  record.sizing->uniform = false;
  EXPECT_EQ(cell(tables_of({record}).front(), 0, "steps"), "–");
}

TEST(UseTables, SayWhichMethodIsBestAtWhat) {
  const std::string best = tables_of(two_methods()).front().remarks.front();
  EXPECT_NE(best.find("ours at condition, Poisson max, Poisson L2"), std::string::npos) << best;
  EXPECT_NE(best.find("theirs at step factor, steps"), std::string::npos) << best;
  EXPECT_EQ(best.find("gradient"), std::string::npos) << best;  // equal, so nobody wins
}

TEST(UseTables, MethodsThatCouldNotBeMatchedAreNotCountedAsBest) {
  std::vector<RunRecord> records = two_methods();
  for (std::size_t n = 3; n < 6; ++n) records[n].match = MatchRecord{16000.0, 1.0, 3, "it meshes the lattice"};
  const Table table = tables_of(records).front();
  EXPECT_EQ(table.rows[1].front().text(), "theirs ‡");
  EXPECT_EQ(table.remarks.front().find("theirs"), std::string::npos) << table.remarks.front();
}

TEST(UseTables, WithoutOrdersHaveNoSuchColumns) {
  const std::vector<Table> tables = tables_of({sample_level("sphere", "ours", 1000, 0.2, 2.0)});
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables.front().header.back(), "meshing s");
  EXPECT_EQ(tables.front().rows.front().front().text(), "ours");
}

TEST(UseTables, ShowWhyThereIsNoMeshAndWhatWasNotMeasured) {
  std::vector<RunRecord> records = {sample_level("sphere", "ours", 1000, 0.2, 2.0),
                                    sample_level("sphere", "open", 1000, 0.2, 2.0),
                                    sample_level("sphere", "slow", 1000, 0.2, 2.0)};
  records[1].measurement->set("boundary_edges", 3);
  records[1].measurement->set("poisson_l2", std::nullopt);
  records[2].status = Status::timeout;
  records[2].measurement.reset();
  const Table table = tables_of(records).front();
  EXPECT_EQ(table.rows[1].front().text(), "open †");
  EXPECT_EQ(cell(table, 1, "Poisson L2"), "–");
  EXPECT_EQ(cell(table, 2, "vertices"), "timeout");
  EXPECT_EQ(cell(table, 2, "condition"), "–");
}

TEST(UseTables, AreNotThereForRunsWithoutFiguresOfUse) {
  const RunRecord plain = without_use(sample_record("skull", "ours"));
  EXPECT_TRUE(tables_of({plain}).empty());
  const std::vector<Table> tables = tables_of({plain, sample_level("sphere", "ours", 1000, 0.2, 2.0)});
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables.front().title, "What a simulation pays and gets: sphere");
}

TEST(UseTables, OfManyDataSetsAreOneOfMedians) {
  std::vector<RunRecord> records;
  for (std::size_t n = 0; n <= many_datasets; ++n) {
    records.push_back(sample_level("set-" + std::to_string(n), "ours", 1000, 0.2, 2.0));
    records.back().measurement->set("condition", 6.0 + static_cast<double>(n));
  }
  const std::vector<Table> tables = tables_of(records);
  ASSERT_EQ(tables.size(), 1U);
  ASSERT_EQ(tables.front().rows.size(), 1U);
  EXPECT_EQ(cell(tables.front(), 0, "condition"), "10.0 (6.00–14.0)");
}

}  // namespace
}  // namespace isobench
