#include "isobench/methods/advancing-front/seeds.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/advancing-front/fences.h"
#include "isobench/methods/lattice/marching_cubes.h"

namespace isobench::advancing_front {
namespace {

TEST(AdvancingFrontSeeds, ComponentsAreLargestFirstAndHaveEveryVertexOnce) {
  TriangleMesh mesh;
  for (int n = 0; n < 7; ++n) mesh.vertices.emplace_back(n, n % 2, 0.0);
  mesh.triangles = {{0, 1, 2}, {5, 6, 4}, {4, 3, 5}};
  const auto components = components_of(mesh);
  ASSERT_EQ(components.size(), 2U);
  EXPECT_EQ(components[0].vertices, (std::vector<std::uint32_t>{3, 4, 5, 6}));
  EXPECT_EQ(components[1].vertices, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_NEAR(components[1].diagonal(), std::hypot(2.0, 1.0), 1e-12);
}

// Two balls a small distance apart: vertices of one ball do not count as vertices of the other, even where the two are
// close.
TEST(AdvancingFrontSeeds, ComponentsWithoutAVertexAreFound) {
  const Isosurface surface(sample_phantom(phantom("near-spheres"), 96), 0.0);
  Monitor monitor;
  const TriangleMesh mesh = marching_cubes(surface, monitor);
  const auto components = components_of(mesh);
  ASSERT_EQ(components.size(), 2U);
  const Step step = [](const Eigen::Vector3d&) { return 1.0; };
  std::vector<Vertex> on_first;
  for (const std::uint32_t n : components[0].vertices) {
    on_first.push_back(make_vertex(surface, step, mesh.vertices[n]));
  }
  EXPECT_TRUE(components_without(surface, mesh, {components[0]}, on_first).empty());
  const auto bare = components_without(surface, mesh, components, on_first);
  ASSERT_EQ(bare.size(), 1U);
  EXPECT_EQ(bare[0].vertices, components[1].vertices);
  // A vertex moved across the gap is nearest to the other ball, but its normal points towards it.
  Vertex facing = on_first.front();
  facing.x = mesh.vertices[components[1].vertices.front()];
  facing.normal = -make_vertex(surface, step, facing.x).normal;
  EXPECT_EQ(components_without(surface, mesh, components, {facing}).size(), 2U);
  facing.normal = -facing.normal;
  EXPECT_EQ(components_without(surface, mesh, components, {facing}).size(), 1U);
}

TEST(AdvancingFrontSeeds, StartWhereStepsAreLong) {
  const Isosurface surface(sample_phantom(phantom("sphere"), 32), 0.0);
  Monitor monitor;
  const TriangleMesh mesh = marching_cubes(surface, monitor);
  const Component whole = components_of(mesh).at(0);
  const Step step = [](const Eigen::Vector3d& x) { return x[0]; };
  const auto points = starting_points(mesh, whole, step, 1);
  ASSERT_GT(points.size(), 10U);
  for (std::size_t n = 1; n < points.size(); ++n) EXPECT_LE(points[n][0], points[n - 1][0]);
  EXPECT_EQ(points, starting_points(mesh, whole, step, 1));
  EXPECT_NE(points, starting_points(mesh, whole, step, 2));
}

TEST(AdvancingFrontSeeds, TheTriangleIsNearlyEquilateralOnTheSurfaceAndFacesOutwards) {
  const Isosurface surface(sample_phantom(phantom("torus"), 48), 0.0);
  Monitor monitor;
  const TriangleMesh mesh = marching_cubes(surface, monitor);
  const double length = 1.5 * surface.voxel();
  const Step step = [length](const Eigen::Vector3d&) { return length; };
  for (std::size_t n = 0; n < mesh.vertices.size(); n += 500) {
    const auto corners = seed_triangle(surface, step, mesh.vertices[n], n);
    ASSERT_TRUE(corners.has_value());
    const Tentative t{{corners->data(), &(*corners)[1], &(*corners)[2]}};
    EXPECT_GT(normal_agreement(t), 0.9);
    EXPECT_LT(circumradius_over_inradius(t), 2.2);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(((*corners)[k].x - (*corners)[(k + 1) % 3].x).norm(), length, 0.15 * length);
      const Jet jet = surface.value_gradient((*corners)[k].x);
      EXPECT_LT(std::abs(jet.value) / jet.gradient.norm(), 2e-6 * surface.voxel());
    }
  }
}

TEST(AdvancingFrontSeeds, NoTriangleWhereTheSurfaceBendsTooMuch) {
  const Isosurface surface(sample_phantom(phantom("sphere"), 32), 0.0);
  Monitor monitor;
  const TriangleMesh mesh = marching_cubes(surface, monitor);
  const Step step = [&](const Eigen::Vector3d&) { return surface.extent().norm(); };
  EXPECT_FALSE(seed_triangle(surface, step, mesh.vertices[0], 1).has_value());
}

}  // namespace
}  // namespace isobench::advancing_front
