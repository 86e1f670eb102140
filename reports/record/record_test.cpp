#include "isobench/reports/record/record.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "isobench/reports/record/figure_values.h"
#include "isobench/reports/record/sample_records.h"

namespace isobench {
namespace {

TEST(Record, ComesBackWhole) {
  RunRecord record = sample_record("skull", "particles", "best");
  record.request.match_to = "skull-cvt";
  record.match = MatchRecord{1010.0, 0.75, 3, "none"};
  const std::string text = to_json(record);
  const RunRecord back = record_from_json(text, "test");
  EXPECT_EQ(to_json(back), text);  // a value that is written but not read would differ
  EXPECT_EQ(back.request.parameters, record.request.parameters);
  EXPECT_EQ(back.request.sizing.epsilon, record.request.sizing.epsilon);
  EXPECT_FALSE(back.request.sizing.vertices.has_value());
  EXPECT_EQ(back.request.limit_minutes, 20.0);
  EXPECT_EQ(back.dataset->lattice.size, record.dataset->lattice.size);
  EXPECT_EQ(back.dataset->lattice.direction, record.dataset->lattice.direction);
  EXPECT_EQ(back.measurement->figure("radius_ratio_min"), record.measurement->figure("radius_ratio_min"));
  EXPECT_EQ(back.measurement->histogram("radius_ratio").counts, record.measurement->histogram("radius_ratio").counts);
  EXPECT_EQ(back.measurement->histogram("valence").counts, record.measurement->histogram("valence").counts);
  EXPECT_EQ(back.measurement->figure("euler_reference"), -12.0);
  EXPECT_EQ(back.mesh_checksum, "c0ffee");
  ASSERT_TRUE(back.match.has_value());
  EXPECT_EQ(back.match->vertices, 1010.0);
  EXPECT_EQ(back.match->scale, 0.75);
  EXPECT_EQ(back.match->tries, 3);
  EXPECT_EQ(back.match->reason, "none");
  EXPECT_EQ(back.request.match_to, "skull-cvt");
  ASSERT_TRUE(back.measured_again.has_value());
  EXPECT_EQ(back.measured_again->commit, "fedcba");
  EXPECT_EQ(back.stages.size(), 2U);
  EXPECT_EQ(back.stages[1].cpu_seconds, 3.0);
  EXPECT_EQ(back.traces.at("energy"), record.traces.at("energy"));
}

TEST(Record, FiguresGoByTheirNamesInTheCsv) {
  const nlohmann::json json = nlohmann::json::parse(to_json(sample_record("skull", "particles")));
  EXPECT_EQ(json.at("figures").at("radius_ratio_min").get<double>(), 0.1 + 0.2);
  EXPECT_EQ(json.at("figures").at("euler_reference").get<int>(), -12);
  EXPECT_EQ(json.at("cost").at("seconds_total").get<double>(), 5.25);
  EXPECT_EQ(json.at("request").at("epsilon").get<double>(), 0.5);
  EXPECT_TRUE(json.at("request").at("edge_length").is_null());
}

TEST(Record, AFigureThatWasNotMeasuredIsNullAndComesBackSo) {
  RunRecord record = sample_record("skull", "particles");
  record.measurement->set("edge_over_h0_exceed_count", std::nullopt);
  const std::string text = to_json(record);
  EXPECT_NE(text.find("\"edge_over_h0_exceed_count\": null"), std::string::npos);
  const RunRecord back = record_from_json(text, "test");
  EXPECT_EQ(back.measurement->figure("edge_over_h0_exceed_count"), std::nullopt);
  EXPECT_TRUE(back.measurement->is_known(figure_index("edge_over_h0_exceed_count")));
  EXPECT_TRUE(std::isnan(figure_value(back, "edge_over_h0_exceed_count")));
  EXPECT_EQ(to_json(back), text);
}

TEST(Record, KeepsTheIsovalueAskedForAndWhatIsLeftOut) {
  RunRecord record = sample_record("skull", "particles");
  EXPECT_EQ(to_json(record).find("asked_isovalue"), std::string::npos) << "it is the one that was taken";
  record.request.min_component = 2.5;
  record.request.metrics_of_use = true;
  record.dataset->asked_isovalue = 0.5;
  const RunRecord back = record_from_json(to_json(record), "test");
  EXPECT_EQ(back.request.min_component, 2.5);
  EXPECT_TRUE(back.request.metrics_of_use);
  EXPECT_EQ(back.dataset->asked_isovalue, 0.5);
}

// What version 0.1.0 wrote: no area and volume, valences without bounds.
TEST(Record, OfAnEarlierVersionDoesNotKnowLaterFigures) {
  nlohmann::ordered_json json = nlohmann::ordered_json::parse(to_json(sample_record("skull", "particles")));
  for (const char* later : {"area", "volume", "distance_from_surface_mean", "edge_over_own_h0_max"})
    json["figures"].erase(later);
  json["histograms"]["valence"].erase("low");
  json["histograms"]["valence"].erase("high");
  json["figures"]["of_another_program"] = 3.0;
  json["figures"]["reference_k"] = 3;
  json["request"]["reference_k"] = 3;
  for (const char* later : {"min_component", "metrics_of_use"}) json["request"].erase(later);
  const RunRecord back = record_from_json(json.dump(), "test");
  EXPECT_FALSE(back.measurement->is_known(figure_index("area")));
  EXPECT_FALSE(back.measurement->is_known(figure_index("edge_over_own_h0_max")));
  EXPECT_TRUE(back.measurement->is_known(figure_index("edge_over_own_h0_exceed_percent")));
  EXPECT_EQ(back.measurement->figure("volume"), std::nullopt);
  EXPECT_EQ(back.measurement->histogram("valence").high, 6.0);
  EXPECT_EQ(to_json(back).find("\"area\""), std::string::npos) << "it stays unknown";
  EXPECT_EQ(to_json(back).find("reference_k"), std::string::npos) << "no figure any more";
}

TEST(Figures, OfARunHaveOneDeclarationEach) {
  std::set<std::string> names;
  for (const std::string& name : figure_names()) {
    EXPECT_TRUE(names.insert(name).second) << name << " is declared twice";
    EXPECT_EQ(figure_declaration(name).name, name);
  }
  const RunRecord record = sample_record("skull", "particles");
  EXPECT_EQ(figure_value(record, "seconds_total"), 5.25);
  EXPECT_EQ(figure_of("euler")(record), -14.0);
  EXPECT_TRUE(std::isnan(figure_value(RunRecord(), "euler")));
  EXPECT_TRUE(std::isnan(figure_value(RunRecord(), "seconds_total")));
  try {
    figure_of("seconds_totla");
    FAIL() << "found";
  } catch (const std::logic_error& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'seconds_total'?"), std::string::npos) << error.what();
  }
}

TEST(Record, NumbersThatAreNotFiniteComeBackAsNotANumber) {
  RunRecord record = sample_record("skull", "particles");
  record.measurement->set("edge_over_h0_max", std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(record_from_json(to_json(record), "test").measurement->number("edge_over_h0_max")));
}

TEST(Record, AFailedRunHasAReasonAndNoFigures) {
  RunRecord record = sample_record("skull", "particles");
  record.status = Status::timeout;
  record.reason = "not finished after 20 minutes";
  record.measurement.reset();
  const RunRecord back = record_from_json(to_json(record), "test");
  EXPECT_EQ(back.status, Status::timeout);
  EXPECT_EQ(back.reason, record.reason);
  EXPECT_FALSE(back.measurement.has_value());
}

std::string complaint(const std::string& text) {
  try {
    record_from_json(text, "results/x/run.json");
  } catch (const DataError& error) {
    return error.what();
  }
  return "";
}

TEST(Record, DamageIsOneSentenceThatNamesTheFile) {
  const std::string whole = to_json(sample_record("skull", "particles"));
  const auto changed = [&whole](const std::string& what, const std::string& with) {
    std::string text = whole;
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), with);
  };
  for (const std::string& text :
       {std::string(), whole.substr(0, whole.size() / 2), std::string("[]"),
        changed("\"status\": \"ok\"", "\"status\": 3"), changed("\"status\": \"ok\"", "\"status\": \"fine\""),
        changed("\"radius_ratio_min\"", "\"radius_ratio_mni\""), changed("\"seed\": 1", "\"seed\": \"one\"")}) {
    const std::string message = complaint(text);
    EXPECT_NE(message.find("results/x/run.json"), std::string::npos) << text.substr(0, 60);
    EXPECT_NE(message.find("run the experiment again"), std::string::npos) << message;
  }
  EXPECT_NE(complaint(changed("\"schema_version\": 1", "\"schema_version\": 2")).find("version 2"), std::string::npos);
}

TEST(Plan, ComesBackWhole) {
  const std::vector<RunRequest> plan = {sample_record("skull", "particles").request,
                                        sample_record("brain", "marching-cubes").request};
  const std::string text = plan_to_json(plan);
  const std::vector<RunRequest> back = plan_from_json(text, "plan.json");
  ASSERT_EQ(back.size(), 2U);
  EXPECT_EQ(back[1].dataset, "brain");
  EXPECT_EQ(plan_to_json(back), text);
  // The text is the same as if the library had written the whole plan at once.
  for (std::size_t runs = 0; runs <= plan.size(); ++runs) {
    const std::string part = plan_to_json({plan.begin(), plan.begin() + static_cast<std::ptrdiff_t>(runs)});
    EXPECT_EQ(nlohmann::ordered_json::parse(part).dump(1) + "\n", part);
  }
}

TEST(Plan, HoldsTheParametersOfItsRunsOnce) {
  std::vector<RunRequest> plan(4, sample_record("skull", "particles").request);
  set_parameter(plan[1], "sweeps", 0.0);
  set_parameter(plan[2], "sweeps", -0.0);  // equal to 0.0, but not the same parameter
  const std::string text = plan_to_json(plan);
  const std::vector<RunRequest> back = plan_from_json(text, "plan.json");
  EXPECT_EQ(&*back[3].parameters, &*back[0].parameters);
  EXPECT_NE(&*back[2].parameters, &*back[1].parameters);
  EXPECT_EQ(plan_to_json(back), text);
}

TEST(Environment, SaysWhereThisRuns) {
  const Environment here = environment();
  EXPECT_FALSE(here.commit.empty());
  EXPECT_GE(here.cores, 1);
  EXPECT_FALSE(here.cpu.empty());
  EXPECT_FALSE(here.compiler.empty());
  for (const char* name : {"VTK", "CGAL", "Eigen", "TBB", "fmt"})
    EXPECT_FALSE(here.libraries->at(name).empty()) << name;
}

TEST(RecordBadInput, NamesAndNumbersThatWouldDoHarm) {
  const std::string whole = to_json(sample_record("skull", "particles", "best"));
  const auto refused = [&](const std::string& what, const std::string& by) {
    std::string text = whole;
    const std::size_t at = text.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    text.replace(at, what.size(), by);
    try {
      record_from_json(text, "run.json");
      ADD_FAILURE() << by << " was read";
    } catch (const DataError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("run.json: ")) << error.what();
    }
  };
  for (const char* name : {"..", ".", "", "../skull", "/tmp", "a/b", ".tmp-skull", "a\\u0000b", "-rf"}) {
    refused("\"skull-best\"", fmt::format("\"{}\"", name));
  }
  refused("\"method\": \"particles\"", "\"method\": \"../particles\"");
  refused("\"dataset\": \"skull\"", "\"dataset\": \"a/.hidden.toml\"");
  for (const char* number : {"1e300", "2.5", "true", "99999999999", "\"2\"", "null"}) {
    refused("\"threads\": 2", fmt::format("\"threads\": {}", number));
  }
  refused("\"seed\": 1", "\"seed\": -1");
  for (const char* number : {"-2000", "2.5", "1e300", "18446744073709551615", "\"2000\""})
    refused("\"triangles\": 2000", fmt::format("\"triangles\": {}", number));
  refused("\"euler\": -14", "\"euler\": -14.5");
}

TEST(RecordBadInput, AReasonThatIsNoUtf8IsStillWritten) {
  RunRecord record = sample_record("skull", "particles");
  record.reason = "method said \xff\xfe";
  record.notes = {"\xc3"};
  const RunRecord back = record_from_json(to_json(record), "test");
  EXPECT_TRUE(back.reason.starts_with("method said ")) << back.reason;
}

}  // namespace
}  // namespace isobench
