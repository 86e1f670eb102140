// Volume and area, against closed forms.
#include <gtest/gtest.h>

#include <numbers>

#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/metrics/measurement.h"

namespace isobench {

namespace {

using sample_meshes::box;
using sample_meshes::together;

Measurement measured(TriangleMesh mesh) {
  Monitor monitor;
  return measure(mesh, MeasuredAgainst{}, monitor);
}

TEST(Volume, OfABox) {
  const Measurement figures = measured(box({1, 2, 3}, {3, 5, 7}));
  EXPECT_NEAR(figures.number("volume"), 24.0, 1e-12);
  EXPECT_NEAR(figures.number("area"), 2.0 * (6.0 + 8.0 + 12.0), 1e-12);
}

TEST(Volume, OfATorus) {
  // Radii 2 and 1. The mesh has 2n sections around the axis, each of n corners, on the torus.
  const Measurement figures = measured(sample_meshes::torus(200));
  constexpr double pi = std::numbers::pi;
  EXPECT_NEAR(figures.number("volume"), 4.0 * pi * pi, 0.01) << "2π²Rr²";
  EXPECT_NEAR(figures.number("area"), 8.0 * pi * pi, 0.01) << "4π²Rr";
}

TEST(Volume, KeepsItsDigitsFarFromTheOrigin) {
  // Coordinates near 1e6 have 1e-10 for their last bit.
  EXPECT_NEAR(measured(box({1e6, 1e6, 1e6}, {1e6 + 1, 1e6 + 1, 1e6 + 1})).number("volume"), 1.0, 1e-9);
}

TEST(Volume, IsNegativeInsideOut) {
  TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
  for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  EXPECT_NEAR(measured(mesh).number("volume"), -1.0, 1e-15);
}

TEST(Volume, AddsUpOverComponentsAndEdgesOfFourTriangles) {
  // Two boxes that share an edge of the mesh, not only its place.
  TriangleMesh mesh = together(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1}));
  EXPECT_NEAR(measured(mesh).number("volume"), 2.0, 1e-12);
  for (Triangle& triangle : mesh.triangles) {
    for (std::uint32_t& v : triangle) {
      for (std::uint32_t first = 0; first < v; ++first) {
        if (mesh.vertices[first] == mesh.vertices[v]) v = first;
      }
    }
  }
  const Measurement joined = measured(mesh);
  EXPECT_EQ(joined.figure("nonmanifold_edges"), 1.0);
  EXPECT_NEAR(joined.number("volume"), 2.0, 1e-12);
}

TEST(Volume, OfAMeshThatIsOpenOrNotOrientedAlikeIsNotMeasured) {
  TriangleMesh open = box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  EXPECT_EQ(measured(open).figure("volume"), std::nullopt);
  EXPECT_NEAR(measured(open).number("area"), 5.5, 1e-12);
  TriangleMesh turned = box({0, 0, 0}, {1, 1, 1});
  std::swap(turned.triangles[3][0], turned.triangles[3][1]);
  EXPECT_EQ(measured(turned).figure("volume"), std::nullopt);
  EXPECT_EQ(measured(sample_meshes::moebius_strip(20)).figure("volume"), std::nullopt);
  EXPECT_EQ(measured(sample_meshes::mesh({{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}})).figure("volume"), std::nullopt);
}

}  // namespace

}  // namespace isobench
