// Polygons are cut into triangles that cover them: areas and shapes are known.
#include "isobench/methods/mesh_files/polygon_mesh.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "isobench/methods/mesh_files/polygon_cutter.h"

namespace isobench {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/// Twice the signed area of a polygon in the plane z = 0.
double twice_area(const Points& polygon) {
  double sum = 0.0;
  for (std::size_t n = 0; n < polygon.size(); ++n) {
    sum += polygon[n].cross(polygon[(n + 1) % polygon.size()]).z();
  }
  return sum;
}

/// Expects that the triangles cover a polygon in the plane z = 0 without overlap: all are turned as it is, their areas
/// sum up to its, and their sides are its sides and diagonals, each diagonal once in either direction.
void expect_covered(const Points& polygon) {
  PolygonCutter cutter;
  ASSERT_TRUE(cutter.cut(polygon));
  const auto count = static_cast<std::uint32_t>(polygon.size());
  ASSERT_EQ(cutter.triangles().size(), polygon.size() - 2);
  double sum = 0.0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const Triangle& t : cutter.triangles()) {
    const double area = twice_area({polygon[t[0]], polygon[t[1]], polygon[t[2]]});
    EXPECT_GE(area * std::copysign(1.0, twice_area(polygon)), 0.0);
    sum += area;
    for (std::size_t c = 0; c < 3; ++c) ++sides[{t[c], t[(c + 1) % 3]}];
  }
  EXPECT_NEAR(sum, twice_area(polygon), 1e-12 * std::abs(sum));
  for (std::uint32_t n = 0; n < count; ++n) {
    EXPECT_EQ((sides[{n, (n + 1) % count}]), 1) << "the polygon's own side " << n;
    sides.erase({n, (n + 1) % count});
  }
  for (const auto& [side, times] : sides) EXPECT_EQ(times, (sides.at({side.second, side.first})));
}

/// A star with `spikes` spikes.
Points star(int spikes, double inner) {
  Points points;
  for (int n = 0; n < 2 * spikes; ++n) {
    const double angle = std::numbers::pi * n / spikes, r = n % 2 == 0 ? 10.0 : inner;
    points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.0);
  }
  return points;
}

TEST(PolygonCutter, CoversConvexAndConcavePolygons) {
  expect_covered({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}});
  expect_covered({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}});  // an arrow's head
  expect_covered({{0, 0, 0}, {0, 4, 0}, {1, 1, 0}, {4, 0, 0}});  // the other way round
  expect_covered({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {6, 9, 0}, {6, 3, 0}, {3, 3, 0}, {3, 9, 0}, {0, 9, 0}});  // a U
  for (const int spikes : {5, 9, 100}) expect_covered(star(spikes, 2.0));
  expect_covered(star(500, 9.99));  // nearly a circle of 1000 corners
  Points comb;                      // 200 teeth
  for (int n = 0; n < 200; ++n) comb.insert(comb.end(), {{2.0 * n, 0, 0}, {2.0 * n + 1, 50, 0}});
  comb.insert(comb.end(), {{400, 0, 0}, {400, -1, 0}, {0, -1, 0}});
  expect_covered(comb);
}

TEST(PolygonCutter, LeavesNoSliverWhereCornersLieOnASide) {
  // A triangle with nine corners on each of its sides, off the line by the rounding of single precision.
  Points points;
  const Eigen::Vector3d corners[] = {{100.1, 200.3, 0}, {117.7, 203.1, 0}, {109.3, 215.9, 0}};
  for (int side = 0; side < 3; ++side) {
    for (int n = 0; n < 10; ++n) {
      const Eigen::Vector3d x = corners[side] + (corners[(side + 1) % 3] - corners[side]) * n / 10.0;
      points.push_back(x.cast<float>().cast<double>());
    }
  }
  PolygonCutter cutter;
  ASSERT_TRUE(cutter.cut(points));
  for (const Triangle& t : cutter.triangles()) {
    const double longest = std::max({(points[t[0]] - points[t[1]]).norm(), (points[t[1]] - points[t[2]]).norm(),
                                     (points[t[2]] - points[t[0]]).norm()});
    EXPECT_GT(twice_area({points[t[0]], points[t[1]], points[t[2]]}) / longest, 0.1) << "height, mm";
  }
}

TEST(PolygonCutter, TakesTheBetterDiagonal) {
  PolygonCutter cutter;
  // A rhombus in a tilted plane: the short diagonal joins corners 1 and 3.
  EXPECT_TRUE(cutter.cut(Points{{-4, 0, -4}, {0, -1, 0}, {4, 0, 4}, {0, 1, 0}}));
  for (const Triangle& t : cutter.triangles()) {
    EXPECT_EQ(std::count(t.begin(), t.end(), 1U) + std::count(t.begin(), t.end(), 3U), 2);
  }
}

TEST(PolygonCutter, TakesASlitToAHole) {
  // A square of 6 mm with a hole of 2 mm: the slit between corners 0 and 4 is named twice.
  const Points points{{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}, {0, 0, 0},
                      {2, 2, 0}, {2, 4, 0}, {4, 4, 0}, {4, 2, 0}, {2, 2, 0}};
  PolygonCutter cutter;
  EXPECT_TRUE(cutter.cut(points));
  double sum = 0.0;
  for (const Triangle& t : cutter.triangles()) {
    const double area = twice_area({points[t[0]], points[t[1]], points[t[2]]});
    EXPECT_GE(area, 0.0);
    sum += area;
  }
  EXPECT_NEAR(sum, 2 * 32.0, 1e-12);
}

TEST(PolygonCutter, SaysThatAPolygonCrossesItself) {
  PolygonCutter cutter;
  EXPECT_FALSE(cutter.cut(Points{{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 3, 0}}));  // a bow tie
  EXPECT_EQ(cutter.triangles().size(), 2U);
  EXPECT_FALSE(cutter.cut(Points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}));  // a line
  EXPECT_EQ(cutter.triangles().size(), 2U);
  EXPECT_FALSE(cutter.cut(Points{{1e300, 0, 0}, {0, 1e300, 0}, {0, 0, 1e300}, {1e300, 1e300, 0}}));
}

TEST(PolygonMesh, DataOfPolygonsGoToTheirTriangles) {
  PolygonMesh polygons;
  polygons.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 2, 0}};
  for (const std::vector<std::uint32_t>& corners :
       {std::vector<std::uint32_t>{0, 1, 2, 3}, {3, 2, 4}, {0, 0, 1, 1}, {0, 1, 1, 2, 0}}) {
    polygons.add_polygon(corners);
  }
  polygons.polygon_data["part"] = {7, 8, 9, 10};
  polygons.notes = {"first"};
  std::vector<std::string> notes;
  const TriangleMesh mesh = to_triangles(polygons, notes);
  EXPECT_EQ(mesh.triangle_data.at("part"), (std::vector<double>{7, 7, 8, 10}));
  EXPECT_EQ(mesh.triangles.at(2), (Triangle{3, 2, 4}));
  EXPECT_EQ(mesh.triangles.size(), 4U);
  EXPECT_EQ(notes,
            (std::vector<std::string>{
                "first", "1 of its 4 faces have more than three corners (up to 4); they were cut into 2 triangles",
                "1 of its faces have fewer than three corners; left out"}));
}

TEST(PolygonMesh, StripsKeepTheirTurn) {
  PolygonMesh mesh;
  const std::vector<std::uint32_t> strip{0, 1, 2, 3, 3, 4, 4, 5, 6};
  EXPECT_EQ(mesh.add_strip(strip), 3U);
  // By positions in the strip, those at even places run forwards: (0 1 2), (2 1 3), and (4 5 6) at place 6.
  EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3, 4, 5, 6}));
}

}  // namespace
}  // namespace isobench
