#include "isobench/methods/cvt/delaunay_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "isobench/foundation/random.h"
#include "isobench/methods/mesh/mesh_facts.h"

namespace isobench::cvt {
namespace {

TEST(CvtDelaunayMesh, FlipsTheLongDiagonal) {
  const std::vector<Eigen::Vector3d> kite{{-3.0, 0.0, 0.0}, {0.0, -1.0, 0.0}, {3.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  DelaunayMesh mesh({{0, 1, 2}, {0, 2, 3}}, kite.size());
  // The kite's corners are at the rim and have only half a fan, so nothing is flipped.
  EXPECT_EQ(mesh.flip(kite), 0U);

  // In a closed surface, a double pyramid over the kite's rim, the diagonal is flipped.
  std::vector<Eigen::Vector3d> points = kite;
  points.emplace_back(0.0, 0.0, -4.0);
  DelaunayMesh closed({{0, 1, 2}, {0, 2, 3}, {1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}}, points.size());
  EXPECT_EQ(closed.flip(points), 1U);
  std::vector<Triangle> with_short;
  for (const Triangle& t : closed.triangles()) {
    if (std::count(t.begin(), t.end(), 1U) + std::count(t.begin(), t.end(), 3U) == 2) with_short.push_back(t);
  }
  EXPECT_EQ(with_short.size(), 2U);
  TriangleMesh result;
  result.vertices = points;
  result.triangles = closed.triangles();
  EXPECT_EQ(mesh_facts(result).open_edges, 0U);
  EXPECT_EQ(mesh_facts(result).euler, 2);
  EXPECT_EQ(closed.flip(points), 0U);
}

// The tetrahedron is nearly flat. Its edges are not Delaunay, but every flip would create an edge that exists already.
TEST(CvtDelaunayMesh, LeavesATetrahedron) {
  const std::vector<Eigen::Vector3d> points{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.3, 0.3, 1e-3}};
  DelaunayMesh mesh({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, points.size());
  EXPECT_EQ(mesh.flip(points), 0U);
}

// A jittered grid, randomly triangulated, is the base of a deep pyramid. Flips make it the Delaunay triangulation, in
// which no circumcircle contains a point.
TEST(CvtDelaunayMesh, IsTheDelaunayTriangulationInThePlane) {
  constexpr std::uint32_t n = 24;
  std::vector<Eigen::Vector3d> points;
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const bool rim = i < 2 || j < 2 || i > n - 3 || j > n - 3;
      const double reach = rim ? 0.0 : 0.45;
      points.emplace_back(i + reach * (2.0 * uniform_random(1, points.size(), 0) - 1.0),
                          j + reach * (2.0 * uniform_random(1, points.size(), 1) - 1.0), 0.0);
    }
  }
  const auto apex = static_cast<std::uint32_t>(points.size());
  points.emplace_back(0.5 * n, 0.5 * n, -2.0 * n);
  std::vector<Triangle> triangles;
  for (std::uint32_t j = 0; j + 1 < n; ++j) {
    for (std::uint32_t i = 0; i + 1 < n; ++i) {
      const std::uint32_t a = j * n + i, b = a + 1, c = b + n, d = a + n;
      // Uses a diagonal only if it inverts no triangle.
      const auto turns = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
        return (points[q] - points[p]).cross(points[r] - points[p])[2] > 0.0;
      };
      const bool ac = turns(a, b, c) && turns(a, c, d);
      const bool bd = turns(a, b, d) && turns(b, c, d);
      ASSERT_TRUE(ac || bd);
      const bool first = ac && (!bd || uniform_random(2, a, 0) < 0.5);
      triangles.push_back(first ? Triangle{a, b, c} : Triangle{a, b, d});
      triangles.push_back(first ? Triangle{a, c, d} : Triangle{b, c, d});
    }
  }
  for (std::uint32_t i = 0; i + 1 < n; ++i) {
    triangles.push_back({i + 1, i, apex});
    triangles.push_back({i * n, (i + 1) * n, apex});
    triangles.push_back({(i + 1) * n + n - 1, i * n + n - 1, apex});
    triangles.push_back({(n - 1) * n + i, (n - 1) * n + i + 1, apex});
  }
  DelaunayMesh mesh(triangles, points.size());
  EXPECT_GT(mesh.flip(points), 100U);
  EXPECT_EQ(mesh.flip(points), 0U);
  std::size_t flat = 0;
  for (const Triangle& t : mesh.triangles()) {
    const Eigen::Vector3d &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    if (normal[2] <= 0.0) continue;  // a side of the pyramid
    ++flat;
    const Eigen::Vector3d to_centre =
        ((c - a).squaredNorm() * normal.cross(b - a) + (b - a).squaredNorm() * (c - a).cross(normal)) /
        (2.0 * normal.squaredNorm());
    for (std::uint32_t p = 0; p < apex; ++p) {
      EXPECT_GT((points[p] - a - to_centre).norm(), to_centre.norm() * (1.0 - 1e-9)) << p;
    }
  }
  EXPECT_EQ(flat, 2U * (n - 1) * (n - 1));
}

}  // namespace
}  // namespace isobench::cvt
