#include "methods/labelled_delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "datasets/error.h"
#include "datasets/phantoms.h"
#include "methods/marching-cubes/marching_cubes.h"
#include "methods/mesh_facts.h"

namespace isobench {
namespace {

/// A dense sample of a phantom closed again.
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

// A voxel's chord of a surface whose radius is some 15 voxels cuts off well under a percent of the volume.
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
  const auto sorted = [](std::vector<Triangle> triangles) {
    for (Triangle& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  };
  EXPECT_EQ(sorted(grown.triangles()), sorted(LabelledDelaunay(all, surface, monitor).triangles()));
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
    // Every point of the dual edge is as far from all three corners.
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
