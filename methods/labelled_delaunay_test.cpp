#include "methods/labelled_delaunay.h"

#include <gtest/gtest.h>

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
  mesh.triangles = labelled_delaunay(mesh.vertices, surface, monitor).triangles;
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

TEST(LabelledDelaunay, RefusesPointsThatSpanNoSolid) {
  const Isosurface surface(sample_phantom(phantom("sphere"), 24), 0.0);
  Monitor monitor;
  EXPECT_THROW(labelled_delaunay({{1, 1, 5}, {2, 1, 5}, {1, 2, 5}, {2, 2, 5}}, surface, monitor), Error);
  EXPECT_THROW(labelled_delaunay({}, surface, monitor), Error);
}

}  // namespace
}  // namespace isobench
