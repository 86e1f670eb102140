#include "isobench/methods/closing/labelled_delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/foundation/error.h"
#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/mesh/mesh_facts.h"

namespace isobench {
namespace {

/// The mesh that closes a dense sample of a phantom.
TriangleMesh closed(const std::string& name, int nodes) {
  const Isosurface surface(sample_phantom(phantom(name), nodes), 0.0);
  Monitor monitor;
  TriangleMesh mesh;
  mesh.vertices = marching_cubes(surface, monitor).vertices;
  mesh.triangles = LabelledDelaunay(mesh.vertices, surface, monitor).triangles();
  return mesh;
}

TEST(LabelledDelaunay, ClosesADenseSampleWithTheRightTopology) {
  for (const char* name : {"sphere", "torus", "ellipsoid", "two-spheres"}) {
    const TriangleMesh mesh = closed(name, 40);
    const MeshFacts facts = mesh_facts(mesh);
    EXPECT_EQ(facts.open_edges, 0U) << name;
    EXPECT_EQ(facts.nonmanifold_edges, 0U) << name;
    EXPECT_EQ(facts.euler, phantom(name).euler) << name;
  }
}

// The radius of the tube is about 15 voxels. Chords of one voxel cut off well under a percent of the volume.
TEST(LabelledDelaunay, TurnsTrianglesOutwards) {
  const TriangleMesh mesh = closed("torus", 60);
  EXPECT_NEAR(mesh_facts(mesh).volume / *phantom("torus").volume, 1.0, 0.01);
}

TEST(LabelledDelaunay, PointsAddedLaterGiveTheSameSurface) {
  const Isosurface surface(sample_phantom(phantom("torus"), 40), 0.0);
  Monitor monitor;
  const std::vector<Eigen::Vector3d> all = marching_cubes(surface, monitor).vertices;
  const auto third = static_cast<std::ptrdiff_t>(all.size() / 3);
  LabelledDelaunay grown({all.begin(), all.begin() + third}, surface, monitor);
  grown.insert({all.begin() + third, all.begin() + 2 * third});
  grown.insert({all.begin() + 2 * third, all.end()});
  EXPECT_EQ(grown.triangles(), LabelledDelaunay(all, surface, monitor).triangles());
}

// Removes and adds points on one of two spheres, in three steps. The mesh must equal the mesh of a new
// triangulation, and facets away from the changed points must be as before.
TEST(LabelledDelaunay, PointsExchangedGiveTheSameSurface) {
  const Isosurface surface(sample_phantom(phantom("two-spheres"), 48), 0.0);
  Monitor monitor;
  std::vector<Eigen::Vector3d> points = marching_cubes(surface, monitor).vertices;
  LabelledDelaunay exchanged(points, surface, monitor);
  for (std::uint32_t step = 2; step < 5; ++step) {
    std::vector<std::uint32_t> removed;
    std::vector<Eigen::Vector3d> kept;
    std::vector<Eigen::Vector3d> added;
    for (std::uint32_t n = 0; n < points.size(); ++n) {
      if (points[n][0] > 0.5 * surface.extent()[0] || n / 50 % step != 1) {
        kept.push_back(points[n]);
        continue;
      }
      removed.push_back(n);
      const Eigen::Vector3d aside = 0.2 * surface.voxel() * Eigen::Vector3d(std::sin(n), std::sin(2.0 * n), 0.7);
      if (n % 7 == 0) added.push_back(points[n]);  // at the position of a removed point
      if (n % 3 != 0) added.push_back(surface.project(points[n] + aside).value());
    }
    ASSERT_FALSE(removed.empty());
    const std::vector<std::uint32_t> changed = exchanged.replace(removed, added);
    EXPECT_LT(changed.size(), 0.8 * static_cast<double>(kept.size() + added.size()));
    EXPECT_TRUE(std::is_sorted(changed.begin(), changed.end()));

    const LabelledDelaunay before(points, surface, monitor);
    points = kept;
    points.insert(points.end(), added.begin(), added.end());
    const LabelledDelaunay after(points, surface, monitor);
    EXPECT_EQ(exchanged.triangles(), after.triangles());
    // The facets without a changed corner are the same before and after, with corners renumbered.
    const auto away = [&changed](const LabelledDelaunay& delaunay, const std::vector<std::uint32_t>& now) {
      std::vector<Triangle> result;
      for (Triangle t : delaunay.triangles()) {
        const bool touched = std::any_of(t.begin(), t.end(), [&](std::uint32_t corner) {
          return now[corner] == UINT32_MAX || std::binary_search(changed.begin(), changed.end(), now[corner]);
        });
        if (touched) continue;
        for (std::uint32_t& corner : t) corner = now[corner];
        result.push_back(t);
      }
      return result;
    };
    std::vector<std::uint32_t> numbers(points.size());
    std::iota(numbers.begin(), numbers.end(), 0U);
    std::vector<std::uint32_t> now;
    for (std::uint32_t n = 0, next = 0; n < kept.size() + removed.size(); ++n)
      now.push_back(std::binary_search(removed.begin(), removed.end(), n) ? UINT32_MAX : next++);
    EXPECT_EQ(away(before, now), away(exchanged, numbers));
    EXPECT_GT(away(before, now).size(), before.triangles().size() / 5);
  }
}

TEST(LabelledDelaunay, AllPointsCanBeExchanged) {
  const Isosurface surface(sample_phantom(phantom("sphere"), 24), 0.0);
  Monitor monitor;
  const std::vector<Eigen::Vector3d> points = marching_cubes(surface, monitor).vertices;
  std::vector<Eigen::Vector3d> others;
  for (const Eigen::Vector3d& x : points)
    others.push_back(surface.project(x + 0.3 * surface.voxel() * Eigen::Vector3d(0.1, 1.0, -0.4)).value());
  LabelledDelaunay exchanged(points, surface, monitor);
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  exchanged.replace(all, others);
  EXPECT_EQ(exchanged.triangles(), LabelledDelaunay(others, surface, monitor).triangles());
  EXPECT_THROW(exchanged.insert({others[7]}), Error);
  LabelledDelaunay another(points, surface, monitor);
  EXPECT_THROW(another.replace(all, {others.begin(), others.begin() + 3}), Error);
}

TEST(LabelledDelaunay, FindsTheNearestPoint) {
  const Isosurface surface(sample_phantom(phantom("sphere"), 24), 0.0);
  Monitor monitor;
  const std::vector<Eigen::Vector3d> points = marching_cubes(surface, monitor).vertices;
  const LabelledDelaunay delaunay(points, surface, monitor);
  for (int n = 0; n < 50; ++n) {
    const Eigen::Vector3d x = surface.extent().cwiseProduct(
        Eigen::Vector3d(std::abs(std::sin(n)), std::abs(std::sin(2.1 * n)), std::abs(std::cos(3.3 * n))));
    const auto nearer = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
      return (a - x).squaredNorm() < (b - x).squaredNorm();
    };
    const Eigen::Vector3d& nearest = *std::min_element(points.begin(), points.end(), nearer);
    EXPECT_EQ((points[delaunay.nearest(x, 0)] - x).norm(), (nearest - x).norm());
  }
}

TEST(LabelledDelaunay, FacetsAtPointsAreThoseOfAll) {
  const Isosurface surface(sample_phantom(phantom("torus"), 40), 0.0);
  Monitor monitor;
  const LabelledDelaunay delaunay(marching_cubes(surface, monitor).vertices, surface, monitor);
  const std::vector<std::uint32_t> asked{3, 4, 77, 78, 500};
  std::vector<Triangle> expected;
  for (const LabelledDelaunay::Facet& facet : delaunay.facets()) {
    if (std::any_of(facet.corners.begin(), facet.corners.end(),
                    [&](std::uint32_t c) { return std::binary_search(asked.begin(), asked.end(), c); }))
      expected.push_back(facet.corners);
  }
  std::vector<Triangle> found;
  for (const LabelledDelaunay::Facet& facet : delaunay.facets_at(asked)) found.push_back(facet.corners);
  EXPECT_EQ(found, expected);
  EXPECT_GT(found.size(), 5U * asked.size() - 2);
  EXPECT_TRUE(delaunay.facets_at({}).empty());
}

TEST(LabelledDelaunay, DualEdgesCrossTheSurfaceNearTheirFacets) {
  const Isosurface surface(sample_phantom(phantom("sphere"), 40), 0.0);
  Monitor monitor;
  const std::vector<Eigen::Vector3d> points = marching_cubes(surface, monitor).vertices;
  const LabelledDelaunay delaunay(points, surface, monitor);
  for (const LabelledDelaunay::Facet& facet : delaunay.facets()) {
    EXPECT_GT(surface.value(facet.inside), 0.0);
    const Eigen::Vector3d centre =
        (points[facet.corners[0]] + points[facet.corners[1]] + points[facet.corners[2]]) / 3.0;
    const Eigen::Vector3d along = (facet.outside - facet.inside).normalized();
    EXPECT_GT(along.dot(outward_normal(surface.value_gradient(centre).gradient)), 0.9);
    // Every point of the dual edge has the same distance to the three corners.
    EXPECT_NEAR((facet.outside - points[facet.corners[0]]).norm(), (facet.outside - points[facet.corners[1]]).norm(),
                1e-6 * (facet.outside - points[facet.corners[0]]).norm());
  }
}

TEST(LabelledDelaunay, RefusesPointsThatSpanNoSolid) {
  const Isosurface surface(sample_phantom(phantom("sphere"), 24), 0.0);
  Monitor monitor;
  EXPECT_THROW(LabelledDelaunay({{1, 1, 5}, {2, 1, 5}, {1, 2, 5}, {2, 2, 5}}, surface, monitor), Error);
  EXPECT_THROW(LabelledDelaunay({}, surface, monitor), Error);
}

}  // namespace
}  // namespace isobench
