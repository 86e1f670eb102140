#include "isobench/methods/particles/cure/cure.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/foundation/random.h"
#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/mesh/mesh_facts.h"
#include "isobench/methods/particles/relaxation/newton.h"
#include "isobench/methods/particles/sampling/seeds.h"

namespace isobench {
namespace {

using particles::CureResult;
using particles::Particles;
using particles::SizedSurface;

// Relaxed particles on a phantom, and the mesh after a cure.
struct Case {
  Case(const std::string& name, int nodes, double edge_length)
      : Case(sample_phantom(phantom(name), nodes), Kernel::bspline, edge_length) {}
  Case(FloatVolume volume, Kernel kernel, double edge_length)
      : surface(std::move(volume), 0.0, Inside::above, kernel),
        field(edge_length),
        sized(surface, field),
        topology(certified_topology(surface, monitor)) {
    const TriangleMesh lattice_mesh = marching_cubes(surface, monitor);
    const auto count = static_cast<std::size_t>(particles::ideal_count(sized, lattice_mesh));
    all = particles::make_particles(sized, particles::eliminate_to_seeds(sized, lattice_mesh, count, 4.0, 1, monitor));
    particles::relax_by_newton(sized, all, 20, monitor);
  }

  CureResult run(int rounds = 30, int relaxations = 0) {
    LabelledDelaunay delaunay(all.points, surface, monitor);
    const CureResult cured =
        particles::cure(sized, topology, all, delaunay, {.relaxations = relaxations, .rounds = rounds}, monitor);
    mesh = TriangleMesh{all.points, delaunay.triangles(), {}, {}};
    return cured;
  }

  Monitor monitor;
  Isosurface surface;
  SizingField field;
  SizedSurface sized;
  CertifiedTopology topology;
  Particles all;
  TriangleMesh mesh;
};

void expect_shape_of(const TriangleMesh& mesh, const Phantom& known) {
  const MeshFacts facts = mesh_facts(mesh);
  EXPECT_EQ(facts.open_edges, 0U);
  EXPECT_EQ(facts.nonmanifold_edges, 0U);
  EXPECT_EQ(facts.euler, known.euler);
  EXPECT_EQ(facts.components, static_cast<std::size_t>(known.components));
}

TEST(ParticlesCure, LeavesADenseSampleAlone) {
  Case torus("torus", 48, 3.0);
  const std::size_t count = torus.all.size();
  const CureResult cured = torus.run();
  EXPECT_EQ(cured.before.all(), 0U);
  EXPECT_EQ(cured.inserted, 0U);
  EXPECT_EQ(cured.rounds, 0);
  EXPECT_EQ(torus.all.size(), count);
  expect_shape_of(torus.mesh, phantom("torus"));
}

// The edges are longer than the sheets are thick and apart. Without a cure, the sheets are joined and have holes.
TEST(ParticlesCure, SeparatesSheetsThatAreCloserThanTheEdgesAreLong) {
  for (const char* name : {"thin-sheets", "near-spheres"}) {
    SCOPED_TRACE(name);
    Case sheets(name, 128, 2.0);
    const CureResult cured = sheets.run();
    EXPECT_GT(cured.before.pinched + cured.before.crossed + cured.before.tilted, 0U);
    EXPECT_GT(cured.inserted, 0U);
    EXPECT_EQ(cured.after.pinched, 0U);
    EXPECT_EQ(cured.after.isolated, 0U);
    EXPECT_EQ(sheets.mesh.vertices.size(), sheets.all.size());
    expect_shape_of(sheets.mesh, phantom(name));
    for (const Eigen::Vector3d& x : sheets.mesh.vertices) {
      const Jet jet = sheets.surface.value_gradient(x);
      EXPECT_LT(std::abs(jet.value) / jet.gradient.norm(), 1e-6 * sheets.surface.voxel());
    }
  }
}

// With relaxations no triangle remains tilted, and no round without a relaxation is needed.
TEST(ParticlesCure, RelaxesUntilNoDefectIsLeft) {
  for (const char* name : {"thin-sheets", "near-spheres"}) {
    SCOPED_TRACE(name);
    Case sheets(name, 128, 2.0);
    const std::size_t count = sheets.all.size();
    const CureResult cured = sheets.run(30, 8);
    EXPECT_GT(cured.relaxations, 0);
    EXPECT_GT(cured.relaxed, cured.inserted);
    EXPECT_EQ(cured.rounds, 0);
    EXPECT_EQ(cured.after.all(), 0U);
    EXPECT_GT(sheets.all.size(), count);
    expect_shape_of(sheets.mesh, phantom(name));
    for (std::size_t n = 0; n < sheets.all.size(); ++n) {
      const Jet jet = sheets.surface.value_gradient(sheets.all.points[n]);
      EXPECT_LT(std::abs(jet.value) / jet.gradient.norm(), 1e-6 * sheets.surface.voxel());
      EXPECT_GT(sheets.all.normals[n].dot(outward_normal(jet.gradient)), 0.9999);
    }
    // A new triangulation of the cured particles gives the same mesh and has no defects.
    LabelledDelaunay again(sheets.all.points, sheets.surface, sheets.monitor);
    EXPECT_EQ(again.triangles(), sheets.mesh.triangles);
    const CureResult nothing = particles::cure(sheets.sized, sheets.topology, sheets.all, again, {}, sheets.monitor);
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
  spheres.all = particles::make_particles(spheres.sized, half);
  const CureResult cured = spheres.run();
  EXPECT_EQ(cured.before.lost, 1U);
  EXPECT_EQ(cured.after.all(), 0U);
  expect_shape_of(spheres.mesh, phantom("near-spheres"));
}

// Two pinches often share the cell whose label mends both; changed for each of them, it would be what it was.
TEST(ParticlesCure, CutsPinchesWhereItMayNotAddParticles) {
  for (const double edge : {1.0, 1.7, 2.0, 2.5, 3.0}) {
    SCOPED_TRACE(edge);
    Case spheres("near-spheres", 48, edge);
    const CureResult cured = spheres.run(0, 0);
    EXPECT_GT(cured.before.pinched, 0U);
    EXPECT_GT(cured.flipped, 0U);
    EXPECT_EQ(cured.after.pinched, 0U);
    EXPECT_EQ(cured.after.differing, 0U);
    EXPECT_EQ(mesh_facts(spheres.mesh).nonmanifold_edges, 0U);
  }
}

TEST(ParticlesCure, SaysWhereTheMeshDiffersIfItMayNotAddParticles) {
  Case sheets("thin-sheets", 96, 4.0);
  const std::size_t count = sheets.all.size();
  const CureResult cured = sheets.run(0, 0);
  EXPECT_EQ(sheets.all.size(), count);
  ASSERT_GT(cured.after.differing, 0U);
  ASSERT_EQ(cured.differs_near.size(), cured.after.differing);
  for (const Eigen::Vector3d& place : cured.differs_near) EXPECT_LT(std::abs(sheets.surface.value(place)), 1e-3);
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

/// Noise from −0.5 to 0.5, one node like the next, and −1 on the border.
FloatVolume white_noise(int nodes) {
  FloatVolume noise;
  noise.lattice.size = {nodes, nodes, nodes};
  noise.samples.resize(noise.lattice.nodes(), -1.0F);
  for (int k = 2; k < nodes - 2; ++k) {
    for (int j = 2; j < nodes - 2; ++j) {
      for (int i = 2; i < nodes - 2; ++i) {
        const std::size_t n = noise.lattice.index(i, j, k);
        noise.samples[n] = static_cast<float>(uniform_random(1, n, 0) - 0.5);
      }
    }
  }
  return noise;
}

// The normals of this surface are not those of its values: at some places all facets are tilted, at any density.
TEST(ParticlesCure, GivesUpWhereParticlesOnlyAddDefects) {
  Case rough(white_noise(14), Kernel::catmull_rom, 0.5);
  const std::size_t count = rough.all.size();
  const CureResult cured = rough.run();
  EXPECT_TRUE(cured.gave_up);
  EXPECT_LT(cured.rounds, 30);
  EXPECT_LT(rough.all.size(), 3 * count);
}

// The number of defects grows at first, because the first particles show next to nothing of the surface.
TEST(ParticlesCure, DoesNotGiveUpWhereParticlesAreFarTooFew) {
  Case intricate(white_noise(18), Kernel::bspline, 8.0);
  const std::size_t count = intricate.all.size();
  const CureResult cured = intricate.run(5, 8);
  EXPECT_FALSE(cured.gave_up);
  EXPECT_LT(cured.after.all(), intricate.all.size() / 50);
  EXPECT_GT(intricate.all.size(), 10 * count);
}

// Without relaxations, h stays as large as it is, and particles have to come ever closer to each other.
TEST(ParticlesCure, PutsParticlesCloserWhereTooFewHaveRoom) {
  Case intricate(white_noise(12), Kernel::bspline, 8.0);
  const CureResult cured = intricate.run(20, 0);
  EXPECT_EQ(cured.after.pinched, 0U);
  EXPECT_EQ(cured.after.isolated, 0U);
  EXPECT_EQ(cured.after.differing, 0U);
}

// In a relaxation that crosses thin sheets, particles lose the surface.
TEST(ParticlesCure, RelaxesParticlesThatStayOnTheSurface) {
  const Case intricate(white_noise(18), Kernel::bspline, 8.0);
  for (std::size_t n = 0; n < intricate.all.size(); ++n) {
    const Jet jet = intricate.surface.value_gradient(intricate.all.points[n]);
    EXPECT_LT(std::abs(jet.value) / jet.gradient.norm(), 1e-6 * intricate.surface.voxel());
  }
}

}  // namespace
}  // namespace isobench
