// Areas of vertices, against sums by hand.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/metrics/measurement.h"
#include "isobench/metrics/test_surfaces.h"

namespace isobench {
namespace {

TEST(VertexAreas, OfATetrahedron) {
  // Three faces of area 1/2 and one of √3/2. The corner at the origin lacks the large one.
  TriangleMesh mesh = sample_meshes::tetrahedron();
  mesh.vertices.emplace_back(5, 5, 5);  // no triangle, no area
  Monitor monitor;
  const Measurement m = measure(mesh, MeasuredAgainst{}, monitor);
  const double mean = (1.5 + 0.5 * std::numbers::sqrt3) / 4.0;
  EXPECT_NEAR(m.number("vertex_area_min"), 0.5 / mean, 1e-12);
  EXPECT_NEAR(m.number("vertex_area_max"), (1.0 + 0.5 * std::numbers::sqrt3) / 3.0 / mean, 1e-12);
}

TEST(VertexAreas, AreJudgedByTheSizesThatWereAskedFor) {
  // An ellipsoid: small sizes where it is curved most.
  FloatVolume volume;
  volume.lattice.size = {33, 33, 33};
  for (int k = 0; k < 33; ++k) {
    for (int j = 0; j < 33; ++j) {
      for (int i = 0; i < 33; ++i) {
        const Eigen::Vector3d x(i - 16, j - 16, k - 16);
        volume.samples.push_back(static_cast<float>(1.0 - x.cwiseQuotient(Eigen::Vector3d(12, 8, 6)).norm()));
      }
    }
  }
  const Isosurface surface(std::move(volume), 0.0);
  Monitor monitor;
  SizingRequest request;
  request.epsilon = 0.8;
  request.delta = 0.4;
  const SizingField sizing = make_sizing_field(surface, request, monitor);
  ASSERT_GT(sizing.largest(), 1.5 * sizing.smallest());
  TriangleMesh mesh = sample_meshes::icosphere(2);
  for (Eigen::Vector3d& v : mesh.vertices) {
    v = v.cwiseProduct(Eigen::Vector3d(12, 8, 6)) + Eigen::Vector3d::Constant(16);
  }
  std::vector<double> areas(mesh.vertices.size(), 0.0);
  double area = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.vertices[t[0]];
    const double of_triangle = 0.5 * (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm();
    area += of_triangle;
    for (const std::uint32_t v : t) areas[v] += of_triangle / 3.0;
  }
  double squares = 0.0;
  for (const Eigen::Vector3d& v : mesh.vertices) squares += std::pow(sizing.h(v), 2);
  std::vector<double> ratios;
  for (std::size_t v = 0; v < areas.size(); ++v) {
    ratios.push_back(areas[v] * squares / (area * std::pow(sizing.h(mesh.vertices[v]), 2)));
  }
  const Measurement adaptive = measure(mesh, surface, sizing, monitor);
  EXPECT_NEAR(adaptive.number("vertex_area_min"), *std::min_element(ratios.begin(), ratios.end()), 1e-9);
  EXPECT_NEAR(adaptive.number("vertex_area_max"), *std::max_element(ratios.begin(), ratios.end()), 1e-9);
  const Measurement uniform = measure(mesh, surface, SizingField(1.0), monitor);
  EXPECT_GT(std::abs(uniform.number("vertex_area_max") - adaptive.number("vertex_area_max")), 0.05);
  EXPECT_GT(std::abs(uniform.number("step_factor") - adaptive.number("step_factor")), 0.1);
}

}  // namespace
}  // namespace isobench
