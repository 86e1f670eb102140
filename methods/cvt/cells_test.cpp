#include "isobench/methods/cvt/cells.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "isobench/foundation/random.h"
#include "isobench/methods/cvt/delaunay_mesh.h"

namespace isobench::cvt {
namespace {

/// Rows of triangles with unit edges in the plane z = 0. Sites within the rim are moved by up to `jitter`.
struct Patch {
  explicit Patch(double jitter) {
    for (std::uint32_t j = 0; j < rows; ++j) {
      for (std::uint32_t i = 0; i < rows; ++i) {
        const bool rim = i == 0 || j == 0 || i == rows - 1 || j == rows - 1;
        const double reach = rim ? 0.0 : jitter;
        points.emplace_back(i + 0.5 * (j % 2) + reach * (2.0 * uniform_random(3, points.size(), 0) - 1.0),
                            j * std::sqrt(0.75) + reach * (2.0 * uniform_random(3, points.size(), 1) - 1.0), 0.0);
      }
    }
    for (std::uint32_t j = 0; j + 1 < rows; ++j) {
      for (std::uint32_t i = 0; i + 1 < rows; ++i) {
        const std::uint32_t a = j * rows + i, b = a + 1, d = a + rows, c = d + 1;
        triangles.push_back(j % 2 == 0 ? Triangle{a, b, d} : Triangle{a, b, c});
        triangles.push_back(j % 2 == 0 ? Triangle{b, c, d} : Triangle{a, c, d});
      }
    }
    // Sites next to the rim cannot all be flipped. The tests below leave them out.
    DelaunayMesh mesh(triangles, points.size());
    mesh.flip(points);
    triangles = mesh.triangles();
  }
  static constexpr std::uint32_t rows = 21;
  static constexpr std::uint32_t middle = 10 * rows + 10;
  std::vector<Eigen::Vector3d> points;
  std::vector<Triangle> triangles;
};

TEST(CvtCells, OfAHexagonalPackingAreRegularHexagons) {
  const Patch patch(0.0);
  const Cells cells = voronoi_cells(patch.points, std::vector<double>(patch.points.size(), 1.0), patch.triangles);
  const double area = std::sqrt(0.75);
  EXPECT_NEAR(cells.mass[Patch::middle], area, 1e-12);
  EXPECT_LT((cells.centroids[Patch::middle] - patch.points[Patch::middle]).norm(), 1e-12);

  // Moving a site away from the middle raises the energy, and the centroid moves back towards the middle.
  std::vector<Eigen::Vector3d> moved = patch.points;
  moved[Patch::middle][0] += 0.05;
  const Cells other = voronoi_cells(moved, std::vector<double>(moved.size(), 1.0), patch.triangles);
  EXPECT_GT(other.energy, cells.energy);
  EXPECT_LT(other.centroids[Patch::middle][0], moved[Patch::middle][0]);
}

// One equilateral triangle holds a sixth of each of three hexagons.
TEST(CvtCells, HaveTheHexagonsEnergy) {
  const std::vector<Eigen::Vector3d> points{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.5, std::sqrt(0.75), 0.0}};
  for (const double h : {1.0, 2.0}) {
    const Cells cells = voronoi_cells(points, {h, h, h}, {{0, 1, 2}});
    const double area = std::sqrt(0.75);
    const double hexagon = 5.0 / (18.0 * std::sqrt(3.0)) * area * area;
    EXPECT_NEAR(cells.energy, 0.5 * hexagon * density(h), 1e-12);
    EXPECT_NEAR(cells.mass[1], area / 6.0 * density(h), 1e-12);
  }
}

TEST(CvtCells, ShareOutTheWholeSurface) {
  const Patch patch(0.3);
  const Cells cells = voronoi_cells(patch.points, std::vector<double>(patch.points.size(), 1.0), patch.triangles);
  double mass = 0.0, area = 0.0;
  for (const double m : cells.mass) mass += m;
  for (const Triangle& t : patch.triangles) {
    const Eigen::Vector3d& a = patch.points[t[0]];
    area += 0.5 * (patch.points[t[1]] - a).cross(patch.points[t[2]] - a).norm();
  }
  EXPECT_NEAR(mass, area, 1e-9);
}

// Second implementation: a fine grid of samples, each assigned to the nearest site.
TEST(CvtCells, AreThoseOfTheNearestSite) {
  const Patch patch(0.3);
  const auto size_at = [](const Eigen::Vector3d& x) { return 1.0 + 0.05 * x[0]; };
  for (const bool graded : {false, true}) {
    std::vector<double> h(patch.points.size(), 1.0);
    for (std::size_t n = 0; n < h.size() && graded; ++n) h[n] = size_at(patch.points[n]);
    const Cells cells = voronoi_cells(patch.points, h, patch.triangles);
    std::vector<double> mass(patch.points.size(), 0.0);
    std::vector<Eigen::Vector3d> moment(patch.points.size(), Eigen::Vector3d::Zero());
    constexpr double step = 0.02;
    for (double y = 5.0; y < 12.0; y += step) {
      for (double x = 6.0; x < 15.0; x += step) {
        const Eigen::Vector3d at(x, y, 0.0);
        std::size_t nearest = 0;
        for (std::size_t n = 1; n < patch.points.size(); ++n) {
          if ((patch.points[n] - at).squaredNorm() < (patch.points[nearest] - at).squaredNorm()) nearest = n;
        }
        const double density_here = graded ? density(size_at(at)) : 1.0;
        mass[nearest] += step * step * density_here;
        moment[nearest] += step * step * density_here * at;
      }
    }
    // Sites whose cells are completely covered by samples.
    for (std::uint32_t j = 8; j <= 11; ++j) {
      for (std::uint32_t i = 9; i <= 12; ++i) {
        const std::size_t n = j * Patch::rows + i;
        // There are 40 samples across a cell, and ρ is linear between sites, circumcentres and midpoints of edges.
        EXPECT_NEAR(cells.mass[n] / mass[n], 1.0, 0.015) << graded;
        EXPECT_LT((cells.centroids[n] - moment[n] / mass[n]).norm(), 0.006) << graded;
      }
    }
  }
}

TEST(CvtCells, LeaveAloneWhatHasNoTriangle) {
  const std::vector<Eigen::Vector3d> points{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {5.0, 5.0, 5.0}};
  const Cells cells = voronoi_cells(points, {1.0, 1.0, 1.0, 1.0}, {{0, 1, 2}, {0, 1, 1}});
  EXPECT_EQ(cells.mass[3], 0.0);
  EXPECT_EQ(cells.centroids[3], points[3]);
  EXPECT_NEAR(cells.mass[0] + cells.mass[1] + cells.mass[2], 0.5, 1e-12);
}

}  // namespace
}  // namespace isobench::cvt
