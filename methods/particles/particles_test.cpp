#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <string>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/mesh/mesh_checksum.h"
#include "isobench/methods/mesh/mesh_facts.h"
#include "isobench/methods/method.h"
#include "isobench/methods/particles/relaxation/newton.h"
#include "isobench/methods/particles/relaxation/population_control.h"
#include "isobench/methods/particles/relaxation/potential.h"
#include "isobench/methods/particles/sampling/seeds.h"
#include "isobench/methods/testing/test_requests.h"

namespace isobench {
namespace {

using particles::Particles;
using particles::SizedSurface;

TriangleMesh particle_mesh_of(const Isosurface& surface, const SizingRequest& request, std::uint64_t seed = 1) {
  const Method& particles = method("particles");
  Monitor monitor;
  return particles.mesh(MeshingTask(surface, request, Parameters(particles.parameters), seed), monitor);
}

TEST(Particles, MeshASpeckBetweenNodes) {
  const Isosurface surface = speck_between_nodes();
  ASSERT_TRUE(marching_cubes(surface, *std::make_unique<Monitor>()).triangles.empty());
  for (const SizingRequest& request : {adaptive(0.5, 0.3), uniform(0.7)}) {
    const MeshFacts facts = mesh_facts(particle_mesh_of(surface, request));
    EXPECT_EQ(facts.open_edges, 0U);
    EXPECT_EQ(facts.components, 1U);
    EXPECT_EQ(facts.euler, 2);
  }
  EXPECT_THROW(particle_mesh_of(surface, with_vertices(100)), UsageError);
}

TEST(ParticlesSeeds, AreAsManyAsAskedOnTheSurfaceAndApart) {
  const Isosurface surface = surface_of("torus", 48);
  Monitor monitor;
  const TriangleMesh lattice_mesh = marching_cubes(surface, monitor);
  const SizingField field(2.0 * surface.voxel());
  const SizedSurface sized(surface, field);
  const auto count = static_cast<std::size_t>(particles::ideal_count(sized, lattice_mesh));
  const auto seeds = particles::eliminate_to_seeds(sized, lattice_mesh, count, 4.0, 1, monitor);
  EXPECT_EQ(seeds.size(), count);
  double nearest = 1e300;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const Jet jet = surface.value_gradient(seeds[i]);
    EXPECT_LT(std::abs(jet.value) / jet.gradient.norm(), 1e-6 * surface.voxel());
    for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, (seeds[i] - seeds[j]).norm());
  }
  // Random points can be arbitrarily close. Elimination gives about 0.7 times the distance in a hexagonal packing.
  EXPECT_GT(nearest, 0.5 * field.h(seeds[0]));
}

TEST(ParticlesRelaxation, LowersTheEnergyOfAUniformPacking) {
  const Isosurface surface = surface_of("sphere", 40);
  Monitor monitor;
  const TriangleMesh lattice_mesh = marching_cubes(surface, monitor);
  const SizingField field(1.5 * surface.voxel());
  const SizedSurface sized(surface, field);
  const auto count = static_cast<std::size_t>(particles::ideal_count(sized, lattice_mesh));
  Particles all =
      particles::make_particles(sized, particles::eliminate_to_seeds(sized, lattice_mesh, count, 4.0, 1, monitor));
  relax_by_newton(sized, all, 60, monitor);
  const std::vector<double>& energy = monitor.traces().at("energy");
  for (std::size_t sweep = 1; sweep < energy.size(); ++sweep) {
    EXPECT_LT(energy[sweep], energy[sweep - 1] * 1.002) << "in sweep " << sweep;  // momentum may overshoot slightly
  }
  // A sphere cannot be packed hexagonally everywhere, and its curvature brings neighbours closer.
  EXPECT_NEAR(energy.back(), particles::ideal_energy, 0.04 * particles::ideal_energy);
}

TEST(ParticlesRelaxation, DropsParticlesThatLieWhereAnotherLies) {
  const Isosurface surface = surface_of("sphere", 20);
  const SizingField field(2.0 * surface.voxel());
  const SizedSurface sized(surface, field);
  const Eigen::Vector3d middle = 0.5 * surface.extent();
  const Eigen::Vector3d a = middle + Eigen::Vector3d(1.0, 0.0, 0.0);
  const Eigen::Vector3d b = middle + Eigen::Vector3d(0.0, 1.0, 0.0);
  const Eigen::Vector3d c = middle + Eigen::Vector3d(0.0, 0.0, 1.0);
  Particles all = particles::make_particles(sized, {b, a, b, c, a, b});
  drop_doubles(all);
  EXPECT_EQ(all.points, (std::vector<Eigen::Vector3d>{b, a, c}));
  EXPECT_EQ(all.spacing.size(), 3U);
}

TEST(ParticlesPopulation, FillsHolesAndThinsCrowds) {
  const Isosurface surface = surface_of("sphere", 40);
  Monitor monitor;
  const TriangleMesh lattice_mesh = marching_cubes(surface, monitor);
  const SizingField field(1.5 * surface.voxel());
  const SizedSurface sized(surface, field);
  const auto ideal = particles::ideal_count(sized, lattice_mesh);
  for (const double share : {0.6, 1.7}) {
    const auto count = static_cast<std::size_t>(share * ideal);
    Particles all =
        particles::make_particles(sized, particles::eliminate_to_seeds(sized, lattice_mesh, count, 4.0, 1, monitor));
    for (int round = 0; round < 10; ++round) {
      relax_by_newton(sized, all, 8, monitor);
      control_population(sized, all, {});
    }
    // The energy limits leave some range of densities unchanged.
    EXPECT_NEAR(static_cast<double>(all.size()) / ideal, 1.0, 0.15) << "from " << share;
  }
}

TEST(ParticlesMethod, MeshesPhantomsClosedWithTheRightTopology) {
  for (const char* name : {"sphere", "torus", "ellipsoid", "slab", "two-spheres", "capsule", "rounded-box"}) {
    const Isosurface surface = surface_of(name, 48);
    const TriangleMesh mesh = particle_mesh_of(surface, adaptive(0.5, 0.3));
    const MeshFacts facts = mesh_facts(mesh);
    EXPECT_EQ(facts.open_edges, 0U) << name;
    EXPECT_EQ(facts.nonmanifold_edges, 0U) << name;
    EXPECT_EQ(facts.euler, phantom(name).euler) << name;
    EXPECT_EQ(facts.components, static_cast<std::size_t>(phantom(name).components)) << name;
    EXPECT_GT(facts.volume, 0.0) << name;
  }
}

// Surfaces that come close to themselves, with the lattices of the catalogue: gaps of 2.2 and 1.1 voxels, and a branch
// 4.4 voxels thin.
TEST(ParticlesMethod, SeparatesCloseParts) {
  const std::vector<std::pair<std::string, int>> lattices = {
      {"thin-sheets", 96}, {"near-spheres", 64}, {"vessel-tree", 96}};
  for (const auto& [name, nodes] : lattices) {
    const Isosurface surface = surface_of(name, nodes);
    for (const SizingRequest& request : {adaptive(0.7, 0.4), uniform(0.8)}) {
      const MeshFacts facts = mesh_facts(particle_mesh_of(surface, request));
      EXPECT_EQ(facts.open_edges, 0U) << name;
      EXPECT_EQ(facts.nonmanifold_edges, 0U) << name;
      EXPECT_EQ(facts.euler, phantom(name).euler) << name;
      EXPECT_EQ(facts.components, static_cast<std::size_t>(phantom(name).components)) << name;
    }
  }
}

/// Percentage of vertices with six edges. In a closed mesh, a vertex has as many triangles as edges.
double valence_six_percent(const TriangleMesh& mesh) {
  std::vector<int> valence(mesh.vertices.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) ++valence[v];
  }
  return 100.0 * static_cast<double>(std::count(valence.begin(), valence.end(), 6)) /
         static_cast<double>(valence.size());
}

TEST(ParticlesMethod, SolvesForTheNumberOfVertices) {
  const Isosurface surface = surface_of("torus", 48);
  SizingRequest request;
  request.vertices = 3000;
  const TriangleMesh mesh = particle_mesh_of(surface, request);
  EXPECT_NEAR(static_cast<double>(mesh.vertices.size()), 3000.0, 60.0);
  EXPECT_GT(valence_six_percent(mesh), 63.0);
}

TEST(ParticlesMethod, KeepsNearlyEveryEdgeBelowH0) {
  const Isosurface surface = surface_of("ellipsoid", 64);
  const SizingRequest request = adaptive(0.3, 0.3);
  const TriangleMesh mesh = particle_mesh_of(surface, request);
  Monitor monitor;
  const SizingField field = make_sizing_field(surface, request, monitor);
  std::size_t edges = 0;
  std::size_t above = 0;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d& a = mesh.vertices[t[k]];
      const Eigen::Vector3d& b = mesh.vertices[t[(k + 1) % 3]];
      ++edges;
      above += (a - b).norm() > 0.5 * (field.h0(a) + field.h0(b)) ? 1 : 0;
    }
  }
  EXPECT_LE(static_cast<double>(above), 0.005 * static_cast<double>(edges));
}

TEST(ParticlesMethod, IsTheSameForAnyNumberOfThreadsAndAnotherForAnotherSeed) {
  const auto with_threads = [&](std::size_t threads, std::uint64_t seed) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return checksum(particle_mesh_of(surface_of("torus", 48), adaptive(0.3, 0.3), seed));
  };
  const std::string one = with_threads(1, 1);
  EXPECT_EQ(one, with_threads(2, 1));
  EXPECT_EQ(one, with_threads(4, 1));
  EXPECT_NE(one, with_threads(2, 2));
}

}  // namespace
}  // namespace isobench
