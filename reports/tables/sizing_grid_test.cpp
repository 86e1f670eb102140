#include "isobench/reports/tables/sizing_grid.h"

#include <gtest/gtest.h>

#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/record/sample_records.h"
#include "isobench/reports/tables/tables.h"
#include "isobench/reports/tables_document.h"

namespace isobench {
namespace {

RunRecord run(double epsilon, double delta, std::uint64_t seed = 1) {
  RunRecord record = sample_record("rounded-box", "particles");
  record.request.sizing.epsilon = epsilon;
  record.request.sizing.delta = delta;
  record.request.seed = seed;
  // Seeds scatter around 100/(εδ), 1 − δ and ε.
  const double scatter = 1.0 + 0.01 * (static_cast<double>(seed) - 2.0);
  record.measurement->set("triangles", static_cast<std::size_t>(scatter * 100.0 / (epsilon * delta)));
  record.measurement->set("radius_ratio_min", scatter * (1.0 - delta));
  record.measurement->set("distance_mean", scatter * epsilon);
  return record;
}

Results grid() {
  Results results;
  for (const double epsilon : {1.0, 0.5, 0.25}) {
    for (const double delta : {0.5, 0.25}) {
      for (const std::uint64_t seed : {1, 2, 3}) results.records.push_back(run(epsilon, delta, seed));
    }
  }
  return results;
}

std::string grid_text(const Results& results) {
  std::string text;
  for (const Table& table : sizing_grid_tables(results)) text += markdown(table);
  return text;
}

const Figure triangle_count = figure_of("triangles");
const Figure smallest = figure_of("radius_ratio_min");
const Figure distance = figure_of("distance_mean");

TEST(SizingGrid, IsLaidOutAsTheFigure) {
  const std::string text = grid_text(grid());
  EXPECT_NE(text.find("rounded-box, particles (3 seeds)"), std::string::npos) << text;
  EXPECT_NE(text.find("| ε    | Figure           | δ 0.5 "), std::string::npos) << text;
  EXPECT_NE(text.find("| 0.25 | triangles        | 800 (792–808)       | 1600 (1584–1616)"), std::string::npos) << text;
  EXPECT_NE(text.find("|      | mean distance mm | 0.250 (0.247–0.253) | 0.250 (0.247–0.253)"), std::string::npos)
      << text;
  EXPECT_NE(
      text.find("Of 4 steps to the next smaller ε: the mean distance falls in 4, the number of triangles rises in "
                "4. Of 3 steps to the next smaller δ: the smallest radius ratio rises in 3, the average radius ratio "
                "rises in 0, the number of triangles rises in 3."),
      std::string::npos)
      << text;
  EXPECT_NE(markdown_tables(grid()).find(text), std::string::npos);
}

TEST(SizingGrid, TrendsAreOfMediansAndOfFinishedCells) {
  Results results = grid();
  const auto with = [&results](Along along, const Figure& figure) {
    return trend(sizing_grids(results).at(0), along, figure);
  };
  EXPECT_EQ(with(Along::epsilon, triangle_count).rises, 4);
  EXPECT_EQ(with(Along::delta, distance).rises + with(Along::delta, distance).falls, 0);
  // One bad seed moves no median; two do.
  results.records[3].measurement->set("radius_ratio_min", 0.0);  // ε 1, δ 0.25
  EXPECT_EQ(with(Along::delta, smallest).rises, 3);
  results.records[4].measurement->set("radius_ratio_min", 0.0);
  EXPECT_EQ(with(Along::delta, smallest).rises, 2);
  EXPECT_EQ(with(Along::delta, smallest).falls, 1);
  // As in the table above it, open meshes do not count while another one of the cell is closed.
  for (const std::size_t i : {3, 4}) results.records[i].measurement->set("boundary_edges", 3.0);
  EXPECT_EQ(with(Along::delta, smallest).rises, 3);
  for (std::size_t i : {3, 4, 5}) {
    results.records[i].status = Status::timeout;
    results.records[i].reason = "not finished after 1 minutes";
    results.records[i].measurement.reset();
  }
  EXPECT_EQ(with(Along::delta, smallest).steps, 2);
  EXPECT_EQ(with(Along::epsilon, distance).steps, 3);
  EXPECT_NE(grid_text(results).find("| timeout: not finished after 1 minutes"), std::string::npos);
}

TEST(SizingGrid, ACrossOfVariationsIsNoGrid) {
  Results results;
  results.records = {run(0.5, 0.3), run(1.0, 0.3), run(0.25, 0.3), run(0.5, 0.5), run(0.5, 0.1)};
  EXPECT_TRUE(sizing_grids(results).empty());
  EXPECT_EQ(grid_text(results), "");
  results.records.push_back(run(1.0, 0.5));
  EXPECT_EQ(sizing_grids(results).size(), 1U);
  EXPECT_NE(grid_text(results).find("not run"), std::string::npos);
}

}  // namespace
}  // namespace isobench
