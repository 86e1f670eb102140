// Pictures of made-up scenes, pixel by pixel.
#include "isobench/reports/pictures/render.h"

#include <gtest/gtest.h>

#include <cmath>

#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/reports/pictures/test_pixels.h"

namespace isobench {
namespace {

// A square of two triangles in the plane z = 0, seen from above.
struct Square {
  TriangleMesh mesh = sample_meshes::mesh({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  Scene scene = scene_of({1.0, 0.0});
  View view{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), 2.0, 5.0};

  Scene scene_of(std::vector<double> values) const {
    Scene made;
    made.mesh = &mesh;
    made.values = std::move(values);
    made.legend = "value";
    made.edges = false;
    return made;
  }
};

TEST(DrawnPictures, ShowAMeshInItsPlaceSizeAndColours) {
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

TEST(DrawnPictures, ShowEdgesAndAnOutline) {
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

TEST(DrawnPictures, ShowWhatACloseEyeLooksAtBeforeADeepScene) {
  Square square;
  square.mesh = sample_meshes::together(square.mesh, sample_meshes::box({-1e3, -1e3, -3e3}, {1e3, 1e3, -1e3}));
  square.scene = square.scene_of(std::vector<double>(square.mesh.triangles.size(), 1.0));
  square.scene.outlined = 0;
  square.view.eye_distance = 1.0;
  const Pixels pixels(Renderer(320, 240).draw(square.scene, square.view).png);
  EXPECT_GT(pixels.count(is_red), 300);
}

TEST(DrawnPictures, ShowEveryPoint) {
  Scene scene;
  scene.point_size = 7.0;
  for (int n = 0; n < 5; ++n) scene.points.emplace_back(0.5 * (n - 2), 0.0, 0.0);
  const Pixels pixels(
      Renderer(320, 240).draw(scene, {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), 2.0, 5.0}).png);
  // Half a millimetre is 30 pixels: five balls, each with white between it and the next.
  int marks = 0;
  bool inside = false;
  for (int x = 0; x < 265; ++x) {
    const bool filled = !is_white(pixels.at(x, 120));
    marks += filled && !inside ? 1 : 0;
    inside = filled;
  }
  EXPECT_EQ(marks, 5);
  EXPECT_NEAR(pixels.count([](const Colour& c) { return !is_white(c); }), 5 * 38, 80);  // π/4 · 7²
  EXPECT_TRUE(is_white(pixels.at(320 * 87 / 100, 120)));                                // no legend, no bar
}

TEST(DrawnPictures, ShowValuesOfCornersInTheirRange) {
  Square square;
  square.scene.values.clear();
  square.scene.vertex_values = {20.0, 30.0, 30.0, 20.0};  // grows to the right
  square.scene.low = 20.0;
  square.scene.high = 30.0;
  const Pixels pixels(Renderer(320, 240).draw(square.scene, square.view).png);
  const Colour left = pixels.at(133 - 55, 120);
  const Colour right = pixels.at(133 + 55, 120);
  EXPECT_GT(left.blue, left.green + 40);
  EXPECT_GT(right.red, right.blue + 80);
}

TEST(DrawnPictures, MarkAPlaceThatTheMeshHides) {
  Square square;
  Renderer renderer(320, 240);
  EXPECT_EQ(Pixels(renderer.draw(square.scene, square.view).png).count(is_red), 0);
  square.scene.marked = Eigen::Vector3d(0.5, 0.0, -1.0);
  const Pixels pixels(renderer.draw(square.scene, square.view).png);
  EXPECT_TRUE(is_red(pixels.at(133 + 30, 120)));
  square.scene.marked->z() = 2.0;  // nearer to the eye than to the square
  EXPECT_TRUE(is_red(Pixels(renderer.draw(square.scene, square.view).png).at(133 + 30, 120)));
  EXPECT_NEAR(pixels.count(is_red), 154, 60);  // π/4 · 14²
}

TEST(DrawnPictures, ShowDecadesAlikeWhereColoursAreLogarithmic) {
  Square square;
  square.scene.values = {1e-5, std::sqrt(1e-5 * 1e-2)};
  square.scene.low = 1e-5;
  square.scene.high = 1e-2;
  square.scene.logarithmic = true;
  const Pixels pixels(Renderer(320, 240).draw(square.scene, square.view).png);
  const Colour lowest = pixels.at(133 + 30, 120 - 30);
  const Colour middle = pixels.at(133 - 30, 120 + 30);
  EXPECT_GT(lowest.blue, lowest.green + 40);
  EXPECT_NEAR(middle.green, middle.blue, 15);  // the middle of the scale is blue-green
  EXPECT_GT(middle.green, middle.red + 60);
}

TEST(DrawnPictures, AreTheSameBytesEveryTime) {
  const Square square;
  const std::string first = Renderer(320, 240).draw(square.scene, square.view).png;
  EXPECT_EQ(Renderer(320, 240).draw(square.scene, square.view).png, first);
}

}  // namespace
}  // namespace isobench
