#include "isobench/methods/particles/cure/cure.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/mesh/mesh_facts.h"

namespace isobench {
namespace {

using particles::Cure;
using particles::Particles;
using particles::Spacing;

// Particles on a phantom as they are before they are closed, and what curing makes of them.
struct Case {
  Case(const std::string& name, int nodes, double edge_length)
      : surface(sample_phantom(phantom(name), nodes), 0.0),
        field(edge_length),
        smaller(surface, 0.3),
        spacing{field, 1.0, &smaller},
        lattice_mesh(marching_cubes(surface, monitor)) {
    const auto count = static_cast<std::size_t>(particles::ideal_count(lattice_mesh, spacing));
    all = particles::make_particles(
        surface, spacing, particles::eliminate_to_seeds(surface, lattice_mesh, spacing, count, 4.0, 1, monitor));
    particles::relax(surface, spacing, all, 20, monitor);
  }

  Cure run(int rounds = 30, int relaxations = 0) {
    LabelledDelaunay delaunay(all.points, surface, monitor);
    Cure cured = particles::cure(surface, spacing, &smaller, lattice_mesh, all, delaunay,
                                 {.rounds = rounds, .relaxations = relaxations}, monitor);
    mesh = TriangleMesh{all.points, delaunay.triangles(), {}, {}};
    return cured;
  }

  Monitor monitor;
  Isosurface surface;
  SizingField field;
  particles::SizeBounds smaller;
  Spacing spacing;
  TriangleMesh lattice_mesh;
  Particles all;
  TriangleMesh mesh;
};

void expect_closed(const TriangleMesh& mesh, const Phantom& known) {
  const MeshFacts facts = mesh_facts(mesh);
  EXPECT_EQ(facts.open_edges, 0U);
  EXPECT_EQ(facts.nonmanifold_edges, 0U);
  EXPECT_EQ(facts.euler, known.euler);
  EXPECT_EQ(facts.components, static_cast<std::size_t>(known.components));
}

TEST(ParticlesCure, LeavesADenseSampleAlone) {
  Case torus("torus", 48, 3.0);
  const std::size_t count = torus.all.size();
  const Cure cured = torus.run();
  EXPECT_EQ(cured.before.all(), 0U);
  EXPECT_EQ(cured.inserted, 0U);
  EXPECT_EQ(cured.rounds, 0);
  EXPECT_EQ(torus.all.size(), count);
  expect_closed(torus.mesh, phantom("torus"));
}

// Edges longer than the sheets are thick and apart: without a cure the sheets are welded and pierced.
TEST(ParticlesCure, PartsSheetsThatAreNearerThanTheEdgesAreLong) {
  for (const char* name : {"thin-sheets", "near-spheres"}) {
    SCOPED_TRACE(name);
    Case sheets(name, 128, 2.0);
    const Cure cured = sheets.run();
    EXPECT_GT(cured.before.pinched + cured.before.crossed + cured.before.tilted, 0U);
    EXPECT_GT(cured.inserted, 0U);
    EXPECT_EQ(cured.after.pinched, 0U);
    EXPECT_EQ(cured.after.isolated, 0U);
    EXPECT_EQ(sheets.mesh.vertices.size(), sheets.all.size());
    expect_closed(sheets.mesh, phantom(name));
    for (const Eigen::Vector3d& x : sheets.mesh.vertices) {
      const Jet jet = sheets.surface.value_gradient(x);
      EXPECT_LT(std::abs(jet.value) / jet.gradient.norm(), 1e-6 * sheets.surface.voxel());
    }
  }
}

// With the surroundings relaxed, none of the triangles is tilted any more, and the particles are apart as they should.
TEST(ParticlesCure, RelaxesUntilNothingIsLeft) {
  for (const char* name : {"thin-sheets", "near-spheres"}) {
    SCOPED_TRACE(name);
    Case sheets(name, 128, 2.0);
    const std::size_t count = sheets.all.size();
    const Cure cured = sheets.run(30, 8);
    EXPECT_GT(cured.relaxations, 0);
    EXPECT_GT(cured.relaxed, cured.inserted);
    EXPECT_EQ(cured.rounds, 0);
    EXPECT_EQ(cured.after.all(), 0U);
    EXPECT_GT(sheets.all.size(), count);
    expect_closed(sheets.mesh, phantom(name));
    for (std::size_t n = 0; n < sheets.all.size(); ++n) {
      const Jet jet = sheets.surface.value_gradient(sheets.all.points[n]);
      EXPECT_LT(std::abs(jet.value) / jet.gradient.norm(), 1e-6 * sheets.surface.voxel());
      EXPECT_GT(sheets.all.normals[n].dot(outward_normal(jet.gradient)), 0.9999);
    }
    // What the cure leaves is what a new triangulation of its particles is, and that has nothing to cure.
    LabelledDelaunay again(sheets.all.points, sheets.surface, sheets.monitor);
    EXPECT_EQ(again.triangles(), sheets.mesh.triangles);
    const Cure nothing = particles::cure(sheets.surface, sheets.spacing, &sheets.smaller, sheets.lattice_mesh,
                                         sheets.all, again, {}, sheets.monitor);
    EXPECT_EQ(nothing.before.all(), 0U);
  }
}

TEST(ParticlesCure, FindsAComponentThatHasNoParticles) {
  Case spheres("near-spheres", 64, 3.0);
  const double middle = 0.5 * spheres.surface.extent()[0];
  std::vector<Eigen::Vector3d> half;
  for (const Eigen::Vector3d& x : spheres.all.points) {
    if (x[0] < middle) half.push_back(x);
  }
  ASSERT_LT(half.size(), spheres.all.size());
  spheres.all = particles::make_particles(spheres.surface, spheres.spacing, half);
  const Cure cured = spheres.run();
  EXPECT_EQ(cured.before.lost, 1U);
  EXPECT_EQ(cured.after.all(), 0U);
  expect_closed(spheres.mesh, phantom("near-spheres"));
}

TEST(ParticlesCure, DoesNotDependOnThreads) {
  std::vector<TriangleMesh> meshes;
  for (const std::size_t threads : {1, 4}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    Case sheets("thin-sheets", 96, 2.0);
    sheets.run(3, 2);
    meshes.push_back(std::move(sheets.mesh));
  }
  EXPECT_EQ(meshes[0].vertices, meshes[1].vertices);
  EXPECT_EQ(meshes[0].triangles, meshes[1].triangles);
}

}  // namespace
}  // namespace isobench
