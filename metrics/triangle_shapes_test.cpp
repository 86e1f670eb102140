// Radius ratio and angles, against closed forms and VTK's Verdict.
#include <gtest/gtest.h>
#include <vtkCellType.h>
#include <vtkMeshQuality.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkTriangle.h>

#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/metrics/angles/angles.h"
#include "isobench/metrics/radius_ratio/radius_ratio.h"

namespace isobench {

namespace {

/// Random triangles; every other one is a sliver whose height is 10^-1 to 10^-6 of its base.
std::vector<std::array<Eigen::Vector3d, 3>> random_triangles(int count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-10.0, 10.0);
  std::uniform_real_distribution<double> exponent(-6.0, -1.0);
  const auto point = [&] { return Eigen::Vector3d(coordinate(random), coordinate(random), coordinate(random)); };
  std::vector<std::array<Eigen::Vector3d, 3>> triangles;
  for (int n = 0; n < count; ++n) {
    std::array<Eigen::Vector3d, 3> corners{point(), point(), point()};
    if (n % 2 == 1) {
      const double along = std::abs(coordinate(random)) / 10.0;
      corners[2] = corners[0] + along * (corners[1] - corners[0]) + std::pow(10.0, exponent(random)) * corners[2];
    }
    triangles.push_back(corners);
  }
  return triangles;
}

double radius_ratio_by_verdict(const std::array<Eigen::Vector3d, 3>& corners) {
  vtkNew<vtkTriangle> triangle;
  for (vtkIdType i = 0; i < 3; ++i) {
    triangle->GetPointIds()->SetId(i, i);
    triangle->GetPoints()->SetPoint(i, corners[static_cast<std::size_t>(i)].data());
  }
  return vtkMeshQuality::TriangleRadiusRatio(triangle);
}

TEST(RadiusRatio, KnownTriangles) {
  EXPECT_NEAR(radius_ratio({0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}), 1.0, 1e-15);
  // Legs 3 and 4: r_in = 1, r_circ = 2.5.
  EXPECT_NEAR(radius_ratio({0, 0, 5}, {3, 0, 5}, {0, 4, 5}), 0.8, 1e-15);
  EXPECT_EQ(radius_ratio({0, 0, 0}, {1, 1, 1}, {2, 2, 2}), 0.0);
  EXPECT_EQ(radius_ratio({1, 2, 3}, {1, 2, 3}, {4, 5, 6}), 0.0);
  EXPECT_EQ(radius_ratio({1, 2, 3}, {1, 2, 3}, {1, 2, 3}), 0.0);
}

TEST(RadiusRatio, IsTheReciprocalOfVerdicts) {
  double smallest = 1.0;
  for (const auto& corners : random_triangles(20000)) {
    const double ours = radius_ratio(corners[0], corners[1], corners[2]);
    const double verdict = 1.0 / radius_ratio_by_verdict(corners);
    ASSERT_NEAR(ours, verdict, 1e-10);
    // Slivers need a relative comparison, too. With areas of 10^-7 of the squared base, 9 digits survive rounding.
    ASSERT_NEAR(ours / verdict, 1.0, 1e-8);
    smallest = std::min(smallest, ours);
  }
  EXPECT_LT(smallest, 1e-8) << "no slivers among the triangles";
}

TEST(RadiusRatio, FiguresOfAMesh) {
  // 2,000 ratios in falling order, the k-th being k/2000.
  std::vector<double> ratios;
  for (int k = 2000; k >= 1; --k) ratios.push_back(k / 2000.0);
  const RadiusRatioFigures figures = summarize_radius_ratios(ratios);
  EXPECT_EQ(figures.min, 1 / 2000.0);
  EXPECT_EQ(figures.p01, 2 / 2000.0) << "the second worst of two thousand";
  EXPECT_NEAR(figures.avg, 2001.0 / 4000.0, 1e-14);
  ratios.push_back(1.0);
  EXPECT_EQ(summarize_radius_ratios(ratios).p01, 3 / 2000.0) << "⌈2001/1000⌉ = 3";
  EXPECT_EQ(summarize_radius_ratios({0.25}).p01, 0.25);

  const RadiusRatioFigures tetrahedron = measure_radius_ratio(sample_meshes::tetrahedron());
  // Three right isosceles triangles, Q = 2(√2 − 1), and an equilateral one.
  EXPECT_NEAR(tetrahedron.min, 2.0 * (std::sqrt(2.0) - 1.0), 1e-15);
  EXPECT_NEAR(tetrahedron.avg, (1.0 + 6.0 * (std::sqrt(2.0) - 1.0)) / 4.0, 1e-15);
  EXPECT_EQ(tetrahedron.histogram.counts[82], 3U);
  EXPECT_EQ(tetrahedron.histogram.counts[99], 1U);
}

TEST(Angles, KnownTriangles) {
  const auto right = triangle_angles({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_NEAR(right[0], 90.0, 1e-13);
  EXPECT_NEAR(right[1], 45.0, 1e-13);
  EXPECT_NEAR(right[2], 45.0, 1e-13);
  const auto flat = triangle_angles({0, 0, 0}, {2, 0, 0}, {1, 0, 0});
  EXPECT_EQ(flat[0], 0.0);
  EXPECT_EQ(flat[1], 0.0);
  EXPECT_EQ(flat[2], 180.0);
}

TEST(Angles, KeepTheirDigitsInSlivers) {
  // Height 1e-9 over a base of 2: acos of the cosine would say 0 for all of these.
  const double height = 1e-9;
  const auto sliver = triangle_angles({0, 0, 0}, {2, 0, 0}, {1, height, 0});
  EXPECT_NEAR(sliver[0] / (height * 180.0 / std::numbers::pi), 1.0, 1e-12);
  EXPECT_NEAR((180.0 - sliver[2]) / (2.0 * height * 180.0 / std::numbers::pi), 1.0, 1e-5);
}

TEST(Angles, SumTo180) {
  for (const auto& corners : random_triangles(2000)) {
    const auto angles = triangle_angles(corners[0], corners[1], corners[2]);
    ASSERT_NEAR(angles[0] + angles[1] + angles[2], 180.0, 1e-9);
  }
}

TEST(Angles, FiguresOfAMesh) {
  const AngleFigures figures = measure_angles(sample_meshes::mesh(
      {{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}, {0, 0, 1}, {2, 0, 1}, {1, 0.1, 1}}, {{0, 1, 2}, {3, 4, 5}}));
  const double base = std::atan(0.1) * 180.0 / std::numbers::pi;  // 5.71°
  EXPECT_NEAR(figures.min, base, 1e-12);
  EXPECT_NEAR(figures.max, 180.0 - 2.0 * base, 1e-12);
  EXPECT_EQ(figures.histogram.counts[5], 2U);
  EXPECT_EQ(figures.histogram.counts[168], 1U);
}

}  // namespace

}  // namespace isobench
