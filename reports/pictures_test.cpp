#include "reports/pictures.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>

#include "datasets/error.h"
#include "datasets/test_folder.h"
#include "methods/mesh_checksum.h"
#include "methods/mesh_files.h"
#include "metrics/sample_meshes.h"
#include "reports/sample_records.h"

namespace isobench {
namespace {

struct Colour {
  int red = 0;
  int green = 0;
  int blue = 0;
};

// A picture's pixels, counted from the lower left corner.
class Pixels {
 public:
  explicit Pixels(const std::string& png) : bytes_(png) {
    reader_->SetMemoryBuffer(bytes_.data());
    reader_->SetMemoryBufferLength(static_cast<vtkIdType>(bytes_.size()));
    reader_->Update();
    reader_->GetOutput()->GetDimensions(size_);
  }
  int width() const { return size_[0]; }
  int height() const { return size_[1]; }
  Colour at(int x, int y) const {
    const auto* pixel = static_cast<unsigned char*>(reader_->GetOutput()->GetScalarPointer(x, y, 0));
    return {pixel[0], pixel[1], pixel[2]};
  }
  // How many pixels left of the bar pass.
  template <class Test>
  int count(Test&& passes) const {
    int count = 0;
    for (int y = 0; y < height(); ++y) {
      for (int x = 0; x < 8 * width() / 10; ++x) count += passes(at(x, y)) ? 1 : 0;
    }
    return count;
  }

 private:
  std::string bytes_;
  vtkNew<vtkPNGReader> reader_;
  int size_[3] = {0, 0, 0};
};

bool is_white(const Colour& c) { return c.red > 250 && c.green > 250 && c.blue > 250; }
bool is_red(const Colour& c) { return c.red > 180 && c.green < 90 && c.blue < 90; }
bool is_dark(const Colour& c) { return c.red < 60 && c.green < 60 && c.blue < 60; }

// A square of two triangles in the plane z = 0, seen from above.
struct Square {
  TriangleMesh mesh = sample_meshes::mesh({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  Scene scene{&mesh, {1.0, 0.0}, "value", false, {}};
  View view{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), 2.0, 5.0};
};

TEST(SlowPictures, ShowAMeshInItsPlaceSizeAndColours) {
  const Square square;
  Renderer renderer(320, 240);
  const Pixels pixels(renderer.draw(square.scene, square.view).png);
  ASSERT_EQ(pixels.width(), 320);
  ASSERT_EQ(pixels.height(), 240);
  // Half the height is 2 mm: the square of 2 mm covers 120 pixels by 120 in the middle.
  EXPECT_NEAR(pixels.count([](const Colour& c) { return !is_white(c); }), 120 * 120, 500);
  EXPECT_TRUE(is_white(pixels.at(133 - 64, 120)));
  EXPECT_FALSE(is_white(pixels.at(133 - 56, 120)));
  // The triangle below the diagonal has the value 1: yellow; the other 0: violet.
  const Colour good = pixels.at(133 + 30, 120 - 30);
  const Colour bad = pixels.at(133 - 30, 120 + 30);
  EXPECT_GT(good.red, good.blue + 80);
  EXPECT_GT(bad.blue, bad.green + 40);
  // The bar stands to the right.
  EXPECT_FALSE(is_white(pixels.at(320 * 87 / 100, 120)));
}

TEST(SlowPictures, ShowEdgesAndAnOutline) {
  Square square;
  Renderer renderer(320, 240);
  const int plain = Pixels(renderer.draw(square.scene, square.view).png).count(is_dark);
  square.scene.edges = true;
  const int edges = Pixels(renderer.draw(square.scene, square.view).png).count(is_dark);
  EXPECT_GT(edges, plain + 300);  // four sides of 120 pixels and a diagonal, smoothed
  EXPECT_EQ(Pixels(renderer.draw(square.scene, square.view).png).count(is_red), 0);
  square.scene.outlined = 0;
  EXPECT_GT(Pixels(renderer.draw(square.scene, square.view).png).count(is_red), 300);
}

TEST(SlowPictures, AreTheSameBytesEveryTime) {
  const Square square;
  const std::string first = Renderer(320, 240).draw(square.scene, square.view).png;
  EXPECT_EQ(Renderer(320, 240).draw(square.scene, square.view).png, first);
}

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

TEST(Pictures, LookStraightOntoATriangleWithoutArea) {
  TriangleMesh mesh = sample_meshes::mesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, -1, 0}, {1, 1, 0}},
                                          {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 4}});
  const View view = view_of_triangle(mesh, 0);
  EXPECT_NEAR(view.towards.normalized().z(), 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(view.focus.x(), 1.0);
  EXPECT_GT(view.half_height, 2.0);
}

// A folder with two runs of one dataset and their meshes.
Results stored(const std::filesystem::path& folder) {
  Results results;
  results.records = {sample_record("box", "ours"), sample_record("box", "theirs")};
  for (std::size_t n = 0; n < 2; ++n) {
    TriangleMesh mesh = n == 0 ? sample_meshes::torus(12) : sample_meshes::box({-3, -3, -1}, {3, 3, 1});
    RunRecord& record = results.records[n];
    record.mesh_checksum = checksum(mesh);
    std::filesystem::create_directories(folder / record.request.run);
    write_mesh(mesh, folder / record.request.run / "mesh.vtp");
  }
  return results;
}

TEST(SlowPictures, OfARunAreThreeAndKeptWhileNothingChanges) {
  const TestFolder folder;
  Results results = stored(folder.path());
  const Pictures first = draw_pictures(arrange(results), folder.path());
  EXPECT_TRUE(first.missing.empty());
  ASSERT_EQ(first.pictures.size(), 6U);
  for (const Picture& picture : first.pictures) {
    const Pixels pixels(read_text(folder.path() / picture.file));
    const int filled = pixels.count([](const Colour& c) { return !is_white(c); });
    EXPECT_GT(filled, pixels.width() * pixels.height() / 40) << picture.file;  // nowhere blank
  }
  EXPECT_EQ(first.pictures[0].title, "ours");
  EXPECT_EQ(first.pictures[0].group, first.pictures[1].group);
  const auto written = std::filesystem::last_write_time(folder.path() / first.pictures[0].file);
  draw_pictures(arrange(results), folder.path());
  EXPECT_EQ(std::filesystem::last_write_time(folder.path() / first.pictures[0].file), written);
  // What was lost is made again.
  std::filesystem::remove(folder.path() / first.pictures[0].preview);
  EXPECT_EQ(draw_pictures(arrange(results), folder.path()).pictures.size(), 6U);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / first.pictures[0].preview));
  // Another mesh: other pictures, and none left over.
  results.records[1].mesh_checksum = "another";
  const Pictures second = draw_pictures(arrange(results), folder.path());
  EXPECT_NE(second.pictures[0].file, first.pictures[0].file);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / first.pictures[0].file));
}

TEST(SlowPictures, OfAMeshThatIsGoneAreMissedAloud) {
  const TestFolder folder;
  const Results results = stored(folder.path());
  std::filesystem::remove(folder.path() / results.records[1].request.run / "mesh.vtp");
  const Pictures pictures = draw_pictures(arrange(results), folder.path());
  EXPECT_TRUE(pictures.pictures.empty());
  ASSERT_EQ(pictures.missing.size(), 1U);
  EXPECT_NE(pictures.missing[0].find("mesh.vtp"), std::string::npos);
}

}  // namespace
}  // namespace isobench
