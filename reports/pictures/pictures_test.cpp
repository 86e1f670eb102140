#include "isobench/reports/pictures/pictures.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "isobench/foundation/error.h"
#include "isobench/foundation/testing/test_folder.h"
#include "isobench/methods/mesh/mesh_checksum.h"
#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/methods/mesh_files/mesh_files.h"
#include "isobench/reports/pictures/cameras.h"
#include "isobench/reports/pictures/drawing.h"
#include "isobench/reports/pictures/test_pixels.h"
#include "isobench/reports/record/sample_records.h"
#include "isobench/reports/record/sample_refinement.h"
#include "isobench/reports/runs/run_grid.h"
#include "isobench/reports/survey/sample_survey.h"

namespace isobench {
namespace {

TEST(Pictures, FrameAllMeshes) {
  const TriangleMesh small = sample_meshes::tetrahedron();
  const TriangleMesh far = sample_meshes::box({10, 10, 10}, {12, 12, 12});
  const View view = view_of_all({&small, &far});
  EXPECT_LT((view.focus - Eigen::Vector3d(6, 6, 6)).norm(), 1e-12);
  const Eigen::Vector3d direction = view.towards.normalized();
  for (const Eigen::Vector3d& vertex : far.vertices) {
    const Eigen::Vector3d offset = vertex - view.focus;
    EXPECT_LT((offset - offset.dot(direction) * direction).norm(), 1.5 * view.half_height);
    EXPECT_LT(offset.dot(direction), view.eye_distance);
  }
  EXPECT_LT(closer_view(view, far, 0.1).half_height, view.half_height);
}

TEST(Pictures, LookAlongTheNormalOfAPlace) {
  const TriangleMesh sphere = sample_meshes::icosphere(4);
  const Eigen::Vector3d place = Eigen::Vector3d(1, 2, -2) / 3.0;
  const View view = view_of_place(sphere, place, 0.07);
  EXPECT_LT((view.focus - place).norm(), 0.07);
  EXPECT_GT(view.towards.normalized().dot(place), 0.99);
  EXPECT_NEAR(view.half_height, 0.28, 1e-12);
}

TEST(Pictures, LookStraightOntoATriangleWithoutArea) {
  TriangleMesh mesh = sample_meshes::mesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, -1, 0}, {1, 1, 0}},
                                          {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 4}});
  const View view = view_of_triangle(mesh, 0);
  EXPECT_NEAR(view.towards.normalized().z(), 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(view.focus.x(), 1.0);
  EXPECT_GT(view.half_height, 2.0);
}

void store(RunRecord& record, const TriangleMesh& mesh, const std::filesystem::path& folder) {
  record.mesh_checksum = checksum(mesh);
  std::filesystem::create_directories(folder / record.request.run);
  write_mesh(mesh, folder / record.request.run / "mesh.vtp");
}

// isobench-pictures reads the plan and the records from the folder.
void write_plan(const Results& results, const std::filesystem::path& folder) {
  std::vector<RunRequest> plan;
  for (const RunRecord& record : results.records) {
    plan.push_back(record.request);
    write_record(record, folder / record.request.run / "run.json");
  }
  write_text(folder / "plan.json", plan_to_json(plan));
}

// A folder with two runs of one dataset and their meshes.
Results stored(const std::filesystem::path& folder) {
  Results results;
  results.records = {sample_record("box", "ours"), sample_record("box", "theirs")};
  for (std::size_t n = 0; n < 2; ++n) {
    store(results.records[n], n == 0 ? sample_meshes::torus(12) : sample_meshes::box({-3, -3, -1}, {3, 3, 1}), folder);
  }
  write_plan(results, folder);
  return results;
}

TEST(Pictures, OfManyDataSetsAreThoseOfTheFirstAndOfTheWorst) {
  Results results = sample_survey::results(60);
  results.records[3 * 17].measurement->set("radius_ratio_min", 0.31);
  std::vector<std::string> left_out;
  const std::vector<PictureGroup> groups = picture_groups(results, left_out);
  EXPECT_EQ(groups.front().dataset, opening_dataset(arrange_runs(results)));
  EXPECT_EQ(groups.front().runs.size(), 3U);
  ASSERT_GE(groups.size(), 2U);
  EXPECT_LE(groups.size(), 4U);
  EXPECT_EQ(groups[1].dataset, sample_survey::dataset(17));
  EXPECT_EQ(groups[1].names, std::vector<std::string>{"good"});
  ASSERT_EQ(left_out.size(), 1U);
  EXPECT_NE(left_out[0].find("of 60 data sets"), std::string::npos);
}

TEST(Pictures, OfTooManySizingsAreThoseOfTheFinestMeshes) {
  Results results;
  std::vector<std::string> left_out;
  for (const char* label : {"a", "b", "c", "d", "e", "f", "g", "h", "i"}) {
    for (const double vertices : {1000.0, 9000.0, 3000.0})
      results.records.push_back(sample_level("sphere", label, vertices, 1, 2));
    const std::vector<PictureGroup> groups = picture_groups(results, left_out);
    ASSERT_EQ(groups.size(), 1U);
    const bool all = results.records.size() <= 24;
    EXPECT_EQ(groups[0].runs.size(), all ? results.records.size() : 9U);
    EXPECT_EQ(left_out.empty(), all);
    if (!all) EXPECT_EQ(groups[0].runs.front(), &results.records[1]);
  }
  EXPECT_EQ(left_out.size(), 1U);
}

TEST(DrawnPictures, OfARunAreThreeAndKeptWhileNothingChanges) {
  const TestFolder folder;
  Results results = stored(folder.path());
  const Pictures first = make_pictures(results, folder.path());
  EXPECT_EQ(first.missing, std::vector<std::string>{});
  ASSERT_EQ(first.pictures.size(), 6U);
  for (const Picture& picture : first.pictures) {
    const Pixels pixels(read_text(folder.path() / picture.file));
    const int filled = pixels.count([](const Colour& c) { return !is_white(c); });
    EXPECT_GT(filled, pixels.width() * pixels.height() / 40) << picture.file;  // no picture is blank
  }
  EXPECT_EQ(first.pictures[0].title, "ours");
  EXPECT_EQ(first.pictures[0].group, first.pictures[1].group);
  EXPECT_EQ(first.turnable.size(), 2U);
  const auto written = std::filesystem::last_write_time(folder.path() / first.pictures[0].file);
  make_pictures(results, folder.path());
  EXPECT_EQ(std::filesystem::last_write_time(folder.path() / first.pictures[0].file), written);
  // A lost file is made again.
  std::filesystem::remove(folder.path() / first.pictures[0].preview);
  EXPECT_EQ(make_pictures(results, folder.path()).pictures.size(), 6U);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / first.pictures[0].preview));
  // Another mesh gives other pictures, and the old ones are removed.
  results.records[1].mesh_checksum = "another";
  write_plan(results, folder.path());
  const Pictures second = make_pictures(results, folder.path());
  EXPECT_NE(second.pictures[0].file, first.pictures[0].file);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / first.pictures[0].file));
}

TEST(DrawnPictures, OfAMeshThatIsGoneAreMissedAloud) {
  const TestFolder folder;
  const Results results = stored(folder.path());
  std::filesystem::remove(folder.path() / results.records[1].request.run / "mesh.vtp");
  const Pictures pictures = make_pictures(results, folder.path());
  EXPECT_TRUE(pictures.pictures.empty());
  ASSERT_EQ(pictures.missing.size(), 1U);
  EXPECT_NE(pictures.missing[0].find("mesh.vtp"), std::string::npos);
}

// Writes the files of a run that keeps its artefacts.
void keep_artefacts(RunRecord& record, const TriangleMesh& mesh, const std::filesystem::path& folder) {
  record.request.artefacts = true;
  Artefact axis;
  for (int n = 0; n < 200; ++n) {
    const double angle = 2.0 * M_PI * n / 200;
    axis.points.emplace_back(2.0 * std::cos(angle), 2.0 * std::sin(angle), 0.0);
    axis.points.emplace_back(9.0, 9.0, 0.1 * n);  // outside the torus: not drawn
  }
  axis.data["radius"].assign(axis.points.size(), 1.0);
  Artefact sizing{mesh.vertices, {}};
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    sizing.data["h0"].push_back(1.0 + vertex.x());
    sizing.data["h"].push_back(2.0);
  }
  write_artefacts({{"medial-axis", axis}, {"sizing", sizing}, {"particles", {mesh.vertices, {}}}}, Lattice{},
                  folder / record.request.run);
}

TEST(DrawnPictures, OfWhatARunKeptShowEachStage) {
  const TestFolder folder;
  Results results = stored(folder.path());
  keep_artefacts(results.records[0], sample_meshes::torus(12), folder.path());
  write_plan(results, folder.path());
  const Pictures pictures = make_pictures(results, folder.path());
  EXPECT_EQ(pictures.missing, std::vector<std::string>{});
  ASSERT_EQ(pictures.pictures.size(), 6U + 5U);
  std::map<std::string, std::string> drawn;
  for (const Picture& picture : pictures.pictures) {
    const std::string bytes = read_text(folder.path() / picture.file);
    EXPECT_GT(Pixels(bytes).count([](const Colour& c) { return !is_white(c); }), 1000) << picture.shot;
    if (picture.title == "ours") drawn[picture.shot] = bytes;
  }
  EXPECT_NE(drawn[shots::initial_sizing], drawn[shots::limited_sizing]);
  const auto blue = [](const Colour& c) { return c.blue > c.red + 60; };
  EXPECT_GT(Pixels(drawn[shots::particles]).count(blue), 1000);
  // Edges over h: h is 2 everywhere, and no edge of that torus is longer than 1.6.
  ASSERT_EQ(pictures.edges_over_h.size(), 1U);
  const std::vector<std::uint32_t>& counts = pictures.edges_over_h[0].counts;
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0U), 3U * 12 * 24);
  EXPECT_EQ(std::accumulate(counts.begin() + 80, counts.end(), 0U), 0U);
}

TEST(DrawnPictures, OfAGridStandInItsRows) {
  const TestFolder folder;
  Results results;
  for (const double epsilon : {1.0, 0.5}) {
    for (const double delta : {0.6, 0.3, 0.1}) {
      RunRecord record = sample_record("box", "ours");
      record.request.run += fmt::format("-{}-{}", epsilon, delta);
      record.request.sizing.epsilon = epsilon;
      record.request.sizing.delta = delta;
      record.request.aside = true;
      const TriangleMesh mesh = sample_meshes::torus(static_cast<std::uint32_t>(6.0 / epsilon));
      store(record, mesh, folder.path());
      results.records.push_back(record);
    }
  }
  write_plan(results, folder.path());
  const Pictures pictures = make_pictures(results, folder.path());
  ASSERT_EQ(pictures.pictures.size(), 6U);  // no others, because the runs are aside
  EXPECT_EQ(pictures.across, 3U);
  EXPECT_EQ(pictures.pictures[3].title, "ε 0.5, δ 0.6");
  EXPECT_TRUE(pictures.turnable.empty());
}

}  // namespace
}  // namespace isobench
