#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/mesh/mesh_facts.h"
#include "isobench/methods/method.h"

namespace isobench {
namespace {

TriangleMesh flying_edges_of(const Isosurface& surface) {
  SizingRequest request;
  request.edge_length = 1.0;
  Monitor monitor;
  const Method& m = method("flying-edges");
  return m.mesh(MeshingTask(surface, request, Parameters(m.parameters), 1), monitor);
}

TEST(FlyingEdgesTest, PhantomsAreClosedAndOutwardAndMeetTheirFigures) {
  for (const Phantom& p : phantoms()) {
    // thin-sheets has rims of 1 mm, which the chords of triangles shorten most: it needs the finer lattice.
    const int nodes = p.name == "thin-sheets" ? 160 : 100;
    const MeshFacts facts = mesh_facts(flying_edges_of(Isosurface(sample_phantom(p, nodes), 0.0)));
    EXPECT_EQ(facts.open_edges, 0U) << p.name;
    EXPECT_EQ(facts.euler, p.euler) << p.name;
    EXPECT_EQ(facts.components, static_cast<std::size_t>(p.components)) << p.name;
    EXPECT_GT(facts.volume, 0.0) << p.name;
    // No spline is involved: only the chords of triangles of half a millimetre make volume and area smaller.
    EXPECT_NEAR(facts.volume / p.volume.value_or(facts.volume), 1.0, 0.002) << p.name;
    EXPECT_NEAR(facts.area / p.area.value_or(facts.area), 1.0, 0.002) << p.name;
  }
}

TEST(FlyingEdgesTest, InsideBelowTurnsTheMeshAround) {
  const FloatVolume volume = sample_phantom(phantom("torus"), 50);
  const MeshFacts above = mesh_facts(flying_edges_of(Isosurface(volume, 0.0, Inside::above)));
  const MeshFacts below = mesh_facts(flying_edges_of(Isosurface(volume, 0.0, Inside::below)));
  EXPECT_GT(above.volume, 0.0);
  EXPECT_NEAR(below.volume, -above.volume, 1e-3 * above.volume);
}

TEST(FlyingEdgesTest, VerticesAreOnLatticeEdgesWhereTheSamplesInterpolateToTheIsovalue) {
  FloatVolume volume = sample_phantom(phantom("ellipsoid"), 40);
  volume.lattice.spacing = {0.7, 1.0, 1.9};
  const Isosurface surface(volume, 1.5);
  const Lattice& l = volume.lattice;
  for (const Eigen::Vector3d& x : flying_edges_of(surface).vertices) {
    Eigen::Vector3d u = x.cwiseQuotient(l.spacing);
    Eigen::Index axis = 0;
    (u.array() - u.array().round()).abs().maxCoeff(&axis);
    const Eigen::Vector3i low = u.array().floor().cast<int>();
    Eigen::Vector3i a = u.array().round().cast<int>();
    a[axis] = low[axis];
    Eigen::Vector3i b = a;
    ++b[axis];
    const double t = u[axis] - a[axis];
    EXPECT_NEAR((1.0 - t) * volume.at(a[0], a[1], a[2]) + t * volume.at(b[0], b[1], b[2]), 1.5, 1e-4);
  }
}

TEST(FlyingEdgesTest, TheMeshIsTheSameForAnyNumberOfThreads) {
  ASSERT_TRUE(method("flying-edges").deterministic);
  const Isosurface surface(sample_phantom(phantom("gyroid-ball"), 120), 0.0);
  const TriangleMesh first = flying_edges_of(surface);
  for (const std::size_t threads : {1U, 2U, 4U, 4U, 4U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const TriangleMesh mesh = flying_edges_of(surface);
    EXPECT_TRUE(mesh.vertices == first.vertices) << threads;
    EXPECT_TRUE(mesh.triangles == first.triangles) << threads;
  }
}

}  // namespace
}  // namespace isobench
