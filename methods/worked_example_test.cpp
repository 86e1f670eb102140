// Compiles the method in README.md and checks what the text says about it.
#include <gtest/gtest.h>

#include <cmath>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/mesh/mesh_facts.h"
#include "isobench/methods/method.h"

namespace isobench {

Method method_snapped_cuberille();  // generated/methods/worked_example.cpp

namespace {

TriangleMesh run(const Isosurface& surface, bool snap) {
  const Method method = method_snapped_cuberille();
  Parameters parameters(method.parameters);
  parameters.set(method.parameters, "snap", snap);
  SizingRequest request;
  request.edge_length = 2.0;
  Monitor monitor;
  return method.mesh(MeshingTask(surface, request, parameters, 1), monitor);
}

TEST(WorkedExample, MeshesThePhantomsClosedOutwardAndOnTheSurface) {
  for (const Phantom& p : phantoms()) {
    const Isosurface surface(sample_phantom(p, 64), 0.0);
    const TriangleMesh mesh = run(surface, true);
    const MeshFacts facts = mesh_facts(mesh);
    EXPECT_EQ(facts.open_edges, 0U) << p.name;
    EXPECT_EQ(facts.components, static_cast<std::size_t>(p.components)) << p.name;
    EXPECT_GT(facts.volume, 0.0) << p.name;
    for (const Eigen::Vector3d& x : mesh.vertices) {
      const Jet jet = surface.value_gradient(x);
      ASSERT_LT(std::abs(jet.value) / jet.gradient.norm(), 1e-6 * surface.voxel()) << p.name;
    }
    // The tolerance covers the spline's shift and the chords of triangles as large as voxels, which are up to 0.9 mm.
    EXPECT_NEAR(facts.volume / p.volume.value_or(facts.volume), 1.0, 0.03) << p.name;
  }
}

TEST(WorkedExample, TheSphereIsAManifoldOfTheRightTopology) {
  const MeshFacts facts = mesh_facts(run(Isosurface(sample_phantom(phantom("sphere"), 64), 0.0), true));
  EXPECT_EQ(facts.euler, 2);
  EXPECT_EQ(facts.nonmanifold_edges, 0U);
}

TEST(WorkedExample, WithoutSnappingItIsTheVoxelsThemselves) {
  const Isosurface surface(sample_phantom(phantom("capsule"), 40), 0.0);
  std::size_t inside = 0;
  std::vector<float> slab;
  for (int k = 0; k < surface.lattice().size[2]; ++k) {
    surface.node_values(k, slab);
    for (const float f : slab) inside += f > 0.0F;
  }
  const double voxels = static_cast<double>(inside) * surface.lattice().spacing.prod();
  EXPECT_NEAR(mesh_facts(run(surface, false)).volume / voxels, 1.0, 1e-12);
}

}  // namespace
}  // namespace isobench
