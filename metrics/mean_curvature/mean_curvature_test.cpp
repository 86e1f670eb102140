// The curvature that a mesh shows. On a sphere it depends on the areas alone, so that tori and ellipsoids are the test.
#include "isobench/metrics/mean_curvature/mean_curvature.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/metrics/foot_points/known_surfaces.h"
#include "isobench/metrics/measurement.h"
#include "isobench/metrics/test_surfaces.h"

namespace isobench {
namespace {

FiniteElements elements_for_curvature(const TriangleMesh& mesh) {
  return finite_elements(mesh, sorted_half_edges(mesh));
}

TEST(CurvatureError, OfAnIcosahedronAndASphereOfAnotherRadius) {
  // K x/(2M) of the unit icosahedron is its unit normal, by symmetry and because its triangles are equilateral. Against
  // a sphere of radius R the error is |1 − 1/R|, over 1/R.
  const TriangleMesh mesh = sample_meshes::icosphere(0);
  for (const double radius : {1.0, 1.25, 0.5}) {
    const auto feet = known_surfaces::feet(mesh.vertices, [&](const Eigen::Vector3d& x) {
      return known_surfaces::ellipsoid(Eigen::Vector3d::Constant(radius), x);
    });
    EXPECT_NEAR(curvature_error(elements_for_curvature(mesh), mesh, feet).value(), std::abs(radius - 1.0), 1e-12);
  }
}

TEST(CurvatureError, OnATorusFallsWithTheSquareOfTheEdges) {
  // The lattice of this torus is a smooth image of a plane one; elsewhere the figure need not converge.
  std::vector<double> errors;
  for (const std::uint32_t n : {20U, 40U, 80U}) {
    const TriangleMesh mesh = sample_meshes::torus(n);
    const auto feet = known_surfaces::feet(mesh.vertices, known_surfaces::torus);
    errors.push_back(curvature_error(elements_for_curvature(mesh), mesh, feet).value());
  }
  EXPECT_NEAR(errors[0] / errors[1], 4.0, 0.5);
  EXPECT_NEAR(errors[1] / errors[2], 4.0, 0.2);
  EXPECT_LT(errors[2], 0.01);
}

TEST(CurvatureError, IsThatOfCotangentsAddedUpByHand) {
  const Eigen::Vector3d axes(3.0, 2.0, 1.0);
  TriangleMesh mesh = sample_meshes::icosphere(2);
  for (Eigen::Vector3d& v : mesh.vertices) v = v.cwiseProduct(axes);
  const auto feet =
      known_surfaces::feet(mesh.vertices, [&](const Eigen::Vector3d& x) { return known_surfaces::ellipsoid(axes, x); });
  std::vector<Eigen::Vector3d> sums(mesh.vertices.size(), Eigen::Vector3d::Zero());
  std::vector<double> areas(mesh.vertices.size(), 0.0);
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t a = t[c], b = t[(c + 1) % 3], apex = t[(c + 2) % 3];
      const Eigen::Vector3d u = mesh.vertices[a] - mesh.vertices[apex], v = mesh.vertices[b] - mesh.vertices[apex];
      const double angle = std::acos(u.normalized().dot(v.normalized()));
      sums[a] += 0.5 / std::tan(angle) * (mesh.vertices[a] - mesh.vertices[b]);
      sums[b] += 0.5 / std::tan(angle) * (mesh.vertices[b] - mesh.vertices[a]);
      areas[a] += u.cross(v).norm() / 6.0;
    }
  }
  double largest = 0.0, squares = 0.0, area = 0.0;
  for (std::size_t v = 0; v < areas.size(); ++v) {
    const double slopes = (feet[v].x.array().square() / axes.array().pow(4)).sum();
    const double h = (axes.squaredNorm() - feet[v].x.squaredNorm()) / (2.0 * 36.0 * std::pow(slopes, 1.5));
    const Eigen::Vector3d n = feet[v].x.cwiseQuotient(axes.cwiseProduct(axes)).normalized();
    largest = std::max(largest, (sums[v] / (2.0 * areas[v]) - h * n).norm());
    squares += areas[v] * h * h;
    area += areas[v];
  }
  const double expected = largest / std::sqrt(squares / area);
  EXPECT_GT(expected, 0.05);
  EXPECT_NEAR(curvature_error(elements_for_curvature(mesh), mesh, feet).value() / expected, 1.0, 1e-9);
}

TEST(CurvatureError, VerticesAtABorderDoNotCountAndPlanesHaveNone) {
  TriangleMesh mesh = sample_meshes::torus(40);
  const auto feet = known_surfaces::feet(mesh.vertices, known_surfaces::torus);
  const double whole = curvature_error(elements_for_curvature(mesh), mesh, feet).value();
  mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 40);
  EXPECT_LT(curvature_error(elements_for_curvature(mesh), mesh, feet).value(), 1.1 * whole);
  mesh = sample_meshes::mesh({{5, 5, 10.25}, {15, 5, 10.25}, {15, 15, 10.25}, {5, 15, 10.25}, {10, 10, 10.25}},
                             {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  Monitor monitor;
  const Isosurface surface = plane();
  EXPECT_EQ(measure(mesh, {.surface = &surface}, monitor).figure("curvature_max"), std::nullopt);
}

}  // namespace
}  // namespace isobench
