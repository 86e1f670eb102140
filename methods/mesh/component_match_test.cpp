#include "isobench/methods/mesh/component_match.h"

#include <gtest/gtest.h>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/lattice/marching_cubes.h"

namespace isobench {
namespace {

/// Two spheres apart, and the mesh of marching cubes, which has two pieces.
struct TwoSpheres {
  TwoSpheres()
      : surface(sample_phantom(phantom("two-spheres"), 48), 0.0),
        topology(certified_topology(surface, monitor)),
        mesh(marching_cubes(surface, monitor)) {}

  std::vector<Shown> shown() const { return match_components(mesh, surface, topology).shown; }
  /// The component of a triangle's first corner.
  std::uint32_t component(const Triangle& t) const { return match_components(mesh, surface, topology).of_vertex[t[0]]; }

  Monitor monitor;
  Isosurface surface;
  CertifiedTopology topology;
  TriangleMesh mesh;
};

TEST(ComponentMatch, TwoSpheresAreShownRight) {
  const TwoSpheres spheres;
  EXPECT_EQ(spheres.shown(), (std::vector<Shown>{Shown::right, Shown::right}));
}

TEST(ComponentMatch, AComponentWithoutTrianglesIsLost) {
  TwoSpheres spheres;
  const std::vector<std::uint32_t> of_vertex =
      match_components(spheres.mesh, spheres.surface, spheres.topology).of_vertex;
  std::erase_if(spheres.mesh.triangles, [&](const Triangle& t) { return of_vertex[t[0]] == 0; });
  EXPECT_EQ(spheres.shown(), (std::vector<Shown>{Shown::lost, Shown::right}));
}

TEST(ComponentMatch, ATriangleBetweenThemJoinsBoth) {
  TwoSpheres spheres;
  const Triangle first = spheres.mesh.triangles.front();
  const Triangle last = spheres.mesh.triangles.back();
  ASSERT_NE(spheres.component(first), spheres.component(last));
  spheres.mesh.triangles.push_back({first[0], first[1], last[0]});
  EXPECT_EQ(spheres.shown(), (std::vector<Shown>{Shown::joined, Shown::joined}));
}

TEST(ComponentMatch, WhatIsLeftOutIsDroppedFromTheMesh) {
  TwoSpheres spheres;
  const std::size_t triangles = spheres.mesh.triangles.size();
  drop_left_out(spheres.mesh, spheres.surface, spheres.topology);
  EXPECT_EQ(spheres.mesh.triangles.size(), triangles);
  const std::uint32_t last = spheres.component(spheres.mesh.triangles.back());
  spheres.topology.components[last].is_left_out = true;
  spheres.mesh.triangle_data["number"].resize(triangles);
  for (std::size_t n = 0; n < triangles; ++n) spheres.mesh.triangle_data["number"][n] = static_cast<double>(n);
  const TriangleMesh before = spheres.mesh;
  drop_left_out(spheres.mesh, spheres.surface, spheres.topology);
  EXPECT_LT(spheres.mesh.triangles.size(), triangles);
  std::vector<Shown> expected(2, Shown::right);
  expected[last] = Shown::left_out;
  EXPECT_EQ(spheres.shown(), expected);
  // The data stay with their triangles, and no vertex is left over.
  for (std::size_t n = 0; n < spheres.mesh.triangles.size(); ++n) {
    const auto old = static_cast<std::size_t>(spheres.mesh.triangle_data["number"][n]);
    EXPECT_EQ(spheres.mesh.vertices[spheres.mesh.triangles[n][0]], before.vertices[before.triangles[old][0]]);
  }
  EXPECT_EQ(drop_unused_vertices(spheres.mesh), 0U);
}

TEST(ComponentMatch, ATriangleBetweenALeftOutComponentAndAnotherKeepsBoth) {
  TwoSpheres spheres;
  const Triangle first = spheres.mesh.triangles.front();
  const Triangle last = spheres.mesh.triangles.back();
  spheres.mesh.triangles.push_back({first[0], first[1], last[0]});
  spheres.topology.components[0].is_left_out = true;
  const std::size_t triangles = spheres.mesh.triangles.size();
  drop_left_out(spheres.mesh, spheres.surface, spheres.topology);
  EXPECT_EQ(spheres.mesh.triangles.size(), triangles);
  EXPECT_EQ(spheres.shown(), (std::vector<Shown>{Shown::left_out, Shown::joined}));
}

TEST(ComponentMatch, AHoleMakesAComponentDifferent) {
  TwoSpheres spheres;
  const std::uint32_t component = spheres.component(spheres.mesh.triangles.back());
  spheres.mesh.triangles.pop_back();
  std::vector<Shown> expected(2, Shown::right);
  expected[component] = Shown::different;
  EXPECT_EQ(spheres.shown(), expected);
}

TEST(ComponentMatch, ASecondPieceMakesAComponentDifferent) {
  TwoSpheres spheres;
  const std::uint32_t component = spheres.component(spheres.mesh.triangles.back());
  const Triangle last = spheres.mesh.triangles.back();
  const auto first = static_cast<std::uint32_t>(spheres.mesh.vertices.size());
  for (const std::uint32_t corner : last) spheres.mesh.vertices.push_back(spheres.mesh.vertices[corner]);
  spheres.mesh.triangles.push_back({first, first + 1, first + 2});
  std::vector<Shown> expected(2, Shown::right);
  expected[component] = Shown::different;
  EXPECT_EQ(spheres.shown(), expected);
}

}  // namespace
}  // namespace isobench
