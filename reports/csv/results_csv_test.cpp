#include "isobench/reports/csv/results_csv.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

#include "isobench/foundation/testing/test_text.h"
#include "isobench/reports/record/sample_records.h"

namespace isobench {
namespace {

std::map<std::string, std::string> row(const RunRecord& record) {
  const std::vector<std::string> csv = lines(results_csv({record}));
  const std::vector<std::string> names = csv_cells(csv.at(0));
  const std::vector<std::string> values = csv_cells(csv.at(1));
  EXPECT_EQ(names.size(), values.size());
  std::map<std::string, std::string> result;
  for (std::size_t i = 0; i < names.size(); ++i) result[names[i]] = values[i];
  return result;
}

TEST(ResultsCsv, HasTheseColumnsInThisOrder) {
  EXPECT_EQ(lines(results_csv({})).at(0),
            "run,dataset,method,label,parameters,epsilon,delta,edge_length,match_scale,seed,status,reason,vertices,"
            "triangles,radius_ratio_min,radius_ratio_p01,radius_ratio_avg,angle_min,angle_max,valence_lt5_percent,"
            "valence_5_percent,valence_6_percent,valence_7_percent,valence_gt7_percent,valence_extreme_count,"
            "edge_over_h0_max,edge_over_h0_exceed_percent,edge_over_h0_exceed_count,edge_over_own_h0_max,"
            "edge_over_own_h0_exceed_percent,floor_area_percent,components,"
            "components_reference,euler,euler_reference,boundary_edges,nonmanifold_edges,"
            "nonmanifold_vertices,self_intersections,distance_mean,distance_max,seconds_prepare,seconds_sizing,"
            "seconds_method,seconds_total,peak_memory_mb,repeat,mesh_checksum,match_to,match_vertices,match_reason,"
            "host,exclusive,distance_from_surface_mean,distance_from_surface_max,area,volume,"
            "components_lost,components_joined,components_different,condition,cg_iterations,negative_weights,"
            "negative_weight_rows_percent,obtuse_percent,curvature_max,normal_angle_mean,normal_angle_max,poisson_max,"
            "poisson_l2,gradient_max,pattern_steps,pattern_steps_done,pattern_stable_percent,blow_up_step,step_factor,"
            "step_factor_consistent,vertex_area_min,vertex_area_max,family,closed_manifold,right_topology,"
            "no_self_intersections,angles_35_90,angles_30_100,valences_5_7,no_edge_above_h0");
}

TEST(ResultsCsv, EveryColumnIsDocumented) {
  const std::vector<std::string> header = csv_cells(lines(results_csv({})).at(0));
  std::vector<std::string> documented;
  for (const std::string& line : lines(columns_text())) {
    if (!line.starts_with("| ") || line.starts_with("| Column ") || line.starts_with("| --")) continue;
    documented.push_back(line.substr(2, line.find(' ', 2) - 2));
    // Its last cell is a sentence.
    EXPECT_NE(line.find(". "), std::string::npos) << line;
  }
  EXPECT_EQ(header, documented);
  const std::map<std::string, std::string> values = row(sample_record("skull", "particles"));
  EXPECT_EQ(values.at("repeat"), "1");
  for (const CsvColumn& column : csv_columns()) {
    EXPECT_FALSE(column.definition.empty()) << column.name;
    const bool percent = column.name.ends_with("_percent");
    EXPECT_EQ(column.unit == "%", percent) << column.name;
    EXPECT_EQ(column.unit == "s", column.name.starts_with("seconds_")) << column.name;
  }
}

TEST(ResultsCsv, IsUnroundedAndQuoted) {
  const std::map<std::string, std::string> values = row(sample_record("skull", "particles", "best, so far"));
  EXPECT_EQ(std::strtod(values.at("radius_ratio_min").c_str(), nullptr), 0.1 + 0.2);
  EXPECT_EQ(values.at("label"), "best, so far");
  EXPECT_EQ(values.at("parameters"), "finish=true;start=grid, fine;sweeps=60");
  EXPECT_EQ(values.at("euler"), "-14");
  EXPECT_EQ(values.at("edge_length"), "");
  EXPECT_EQ(values.at("seconds_total"), "5.25");
}

TEST(ResultsCsv, EveryFigureOfAFinishedRunIsThere) {
  RunRecord record = sample_record("skull", "particles");
  record.request.match_to = "skull-cvt";
  record.request.family = "bones";
  record.match = MatchRecord{1010.0, 0.75, 2, ""};
  const std::map<std::string, std::string> values = row(record);
  EXPECT_EQ(values.at("match_scale"), "0.75");
  EXPECT_EQ(values.at("match_vertices"), "1010");
  for (const auto& [name, value] : values) {
    if (name == "reason" || name == "edge_length" || name == "match_reason") continue;
    EXPECT_NE(value, "") << name;
  }
}

TEST(ResultsCsv, AFigureThatWasNotMeasuredIsAnEmptyCell) {
  RunRecord record = sample_record("skull", "particles");
  record.measurement->set("edge_over_h0_exceed_count", std::nullopt);
  record.measurement->set_unknown(figure_index("volume"));
  const std::map<std::string, std::string> values = row(record);
  EXPECT_EQ(values.at("edge_over_h0_exceed_count"), "");
  EXPECT_EQ(values.at("volume"), "");
  EXPECT_EQ(values.at("area"), "0");
  EXPECT_EQ(values.at("no_edge_above_h0"), "");
}

TEST(ResultsCsv, SaysWhichChecksAMeshPasses) {
  RunRecord record = sample_record("skull", "particles");
  record.request.family = "bones";
  record.measurement->set("angle_min", 33.0);
  record.measurement->set("angle_max", 95.0);
  const std::map<std::string, std::string> values = row(record);
  EXPECT_EQ(values.at("family"), "bones");
  EXPECT_EQ(values.at("closed_manifold"), "true");
  EXPECT_EQ(values.at("right_topology"), "false");  // χ is −14 in place of −12
  EXPECT_EQ(values.at("angles_35_90"), "false");
  EXPECT_EQ(values.at("angles_30_100"), "true");
  record.measurement.reset();
  record.status = Status::timeout;
  EXPECT_EQ(row(record).at("closed_manifold"), "");
}

TEST(ResultsCsv, NoTwoColumnsHaveOneName) {
  std::set<std::string> names;
  for (const CsvColumn& column : csv_columns()) EXPECT_TRUE(names.insert(column.name).second) << column.name;
}

TEST(ResultsCsv, AFailedRunKeepsItsRow) {
  RunRecord record = sample_record("skull", "particles");
  record.status = Status::failed;
  record.reason = "ended by SIGSEGV, said \"so\"\nand more";
  record.measurement.reset();
  // The reason has a line break of its own, so look at the text as a whole.
  const std::string csv = results_csv({record});
  EXPECT_NE(csv.find(",failed,\"ended by SIGSEGV, said \"\"so\"\"\nand more\",,,"), std::string::npos) << csv;
}

}  // namespace
}  // namespace isobench
