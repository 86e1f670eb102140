// Pictures of fields that metrics keep with the meshes.
#include "isobench/reports/pictures/field_pictures.h"

#include <gtest/gtest.h>

#include "isobench/foundation/files/whole_files.h"
#include "isobench/foundation/testing/test_folder.h"
#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/methods/mesh_files/mesh_files.h"
#include "isobench/reports/page/page.h"
#include "isobench/reports/pictures/test_pixels.h"
#include "isobench/reports/record/sample_records.h"

namespace isobench {
namespace {

/// Three runs of one data set: spots on the first two, and the last two blow up. The errors grow from run to run.
Results with_fields(const std::filesystem::path& folder) {
  Results results;
  for (const char* label : {"ours", "theirs", "others"}) {
    RunRecord record = sample_record("torus", label);
    Measurement& m = *record.measurement;
    const auto n = static_cast<double>(results.records.size());
    TriangleMesh mesh = sample_meshes::torus(12);
    const std::size_t vertices = mesh.vertices.size();
    m.set("pattern_steps", n < 2 ? 1000.0 + n : 2.5e6);
    m.set("pattern_steps_done", n < 2 ? 1000.0 + n : 0.0);
    m.set("gradient_max", 1.0 + n);
    for (const char* axis : {"blow_up_x", "blow_up_y", "blow_up_z"}) m.set(axis, std::nullopt);
    if (n < 2) mesh.vertex_data["spots"] = std::vector<double>(vertices, 3.0);
    if (n > 0) {
      mesh.vertex_data["blow_up"] = std::vector<double>(vertices, 0.0);
      m.set("blow_up_step", 7);
      m.set("pattern_stable_percent", 0.6);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        m.set(std::string("blow_up_") + "xyz"[axis], mesh.vertices[5][static_cast<Eigen::Index>(axis)]);
      }
    }
    mesh.triangle_data["gradient_error"] = std::vector<double>(mesh.triangles.size(), 1.0 + n);
    record.stages = {{"measure/reaction_diffusion/spots", 3.25, 6.5}};
    record.mesh_checksum = label;
    std::filesystem::create_directories(folder / record.request.run);
    write_mesh(mesh, folder / record.request.run / "mesh.vtp");
    write_record(record, folder / record.request.run / "run.json");
    results.records.push_back(std::move(record));
  }
  std::vector<RunRequest> plan;
  for (const RunRecord& record : results.records) plan.push_back(record.request);
  write_text(folder / "plan.json", plan_to_json(plan));
  return results;
}

TEST(FieldPictures, AreOfTheRunsThatTheDeclarationNames) {
  const TestFolder folder;
  const Results results = with_fields(folder.path());
  std::vector<std::string> left_out;
  const std::vector<PictureGroup> groups = picture_groups(results, left_out);
  ASSERT_EQ(groups.size(), 1U);
  const std::vector<FieldPictures> fields = field_pictures(groups[0], folder.path());
  ASSERT_EQ(fields.size(), 3U);  // poisson_error is nowhere
  EXPECT_EQ(fields[0].field->name, "spots");
  EXPECT_EQ(fields[0].runs, (std::vector<std::size_t>{0, 1, 2})) << "the third in grey";
  EXPECT_EQ(fields[1].field->name, "blow_up");
  EXPECT_EQ(fields[1].runs, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(fields[2].field->name, "gradient_error");
  EXPECT_EQ(fields[2].runs, (std::vector<std::size_t>{0, 2})) << "the first, and the worst";
}

TEST(FieldPictures, OfRunsThatWereNotMeasuredAreNotDrawn) {
  const TestFolder folder;
  Results results = with_fields(folder.path());
  results.records[2].measurement->set_unknown(figure_index("pattern_steps"));
  std::vector<std::string> left_out;
  std::vector<PictureGroup> groups = picture_groups(results, left_out);
  EXPECT_EQ(field_pictures(groups[0], folder.path())[0].runs, (std::vector<std::size_t>{0, 1}));
  for (const RunRecord& record : results.records) {
    write_mesh(sample_meshes::torus(12), folder.path() / record.request.run / "mesh.vtp");
  }
  EXPECT_TRUE(field_pictures(groups[0], folder.path()).empty());
  EXPECT_EQ(shots_of(groups[0], results.records[0], folder.path()).size(), 3U);
  groups[0].grid = true;
  EXPECT_TRUE(field_pictures(groups[0], folder.path()).empty());
}

TEST(FieldPictures, SayStepsAndSeconds) {
  const TestFolder folder;
  Results results = with_fields(folder.path());
  const FieldDeclaration& spots = declared_fields()[0].name == "spots" ? declared_fields()[0] : declared_fields()[2];
  ASSERT_EQ(spots.name, "spots");
  for (RunRecord& record : results.records) record.measured_again.reset();
  EXPECT_EQ(caption_of(spots, results.records[0]), "1000 steps, 3.2 s");
  results.records[2].stages.clear();
  EXPECT_EQ(caption_of(spots, results.records[2]), "needs 2.5 million steps: too many, not done");
  results.records[0].measured_again = MeasuredAgain{};
  EXPECT_EQ(caption_of(spots, results.records[0]), "1000 steps") << "the seconds are of an earlier measurement";
}

TEST(DrawnPictures, OfFieldsStandOnThePageWithTheirMarks) {
  const TestFolder folder;
  const Results results = with_fields(folder.path());
  const Pictures pictures = make_pictures(results, folder.path());
  EXPECT_EQ(pictures.missing, std::vector<std::string>{});
  EXPECT_EQ(pictures.pictures.size(), 3U * 3U + 3U + 2U + 2U);
  const auto pixels_of = [&](const std::string& shot, const std::string& method) {
    for (const Picture& picture : pictures.pictures) {
      if (picture.shot == shot && picture.title == method) return Pixels(read_text(folder.path() / picture.file));
    }
    throw std::logic_error("no picture " + shot);
  };
  const auto is_yellow = [](const Colour& c) { return c.red > c.blue + 80 && c.green > c.blue + 80; };
  const auto is_purple = [](const Colour& c) { return c.blue > c.green + 40; };
  EXPECT_GT(pixels_of("field-spots", "ours").count(is_yellow), 5000);
  EXPECT_EQ(pixels_of("field-spots", "ours").count(is_red), 0);
  EXPECT_GT(pixels_of("field-spots", "theirs").count(is_red), 100);
  EXPECT_EQ(pixels_of("field-spots", "others").count(is_yellow), 0) << "it has no spots";
  EXPECT_GT(pixels_of("field-spots", "others").count(is_red), 100);
  EXPECT_GT(pixels_of("field-blow_up", "others").count(is_purple), 5000);
  EXPECT_EQ(pixels_of("field-blow_up", "others").count(is_red), 0);
  EXPECT_GT(pixels_of("field-gradient_error", "others").count(is_yellow), 5000) << "the largest is the brightest";
  Exhibits exhibits;
  exhibits.pictures = pictures.pictures;
  const std::string html = fields_html(exhibits, folder.path());
  EXPECT_NE(html.find("<h3>torus: a pattern that forms on the mesh</h3>"), std::string::npos);
  EXPECT_LT(html.find("needs 2.5 million steps"), html.find("the error of gradients"));
  std::erase_if(exhibits.pictures, [](const Picture& picture) { return !picture.explanation.empty(); });
  EXPECT_EQ(fields_html(exhibits, folder.path()), "");
  EXPECT_EQ(page(results, exhibits, folder.path()).find("id=\"fields\""), std::string::npos);
}

}  // namespace
}  // namespace isobench
