#include "isobench/methods/closing/tight_cocone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/random.h"
#include "isobench/methods/closing/cocone.h"
#include "isobench/methods/closing/labelled_delaunay.h"
#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/mesh/mesh_facts.h"
#include "isobench/methods/particles/relaxation/newton.h"
#include "isobench/methods/particles/sampling/seeds.h"

namespace isobench {
namespace {

/// An even sample of the surface of a phantom, with particles a voxel apart.
struct Sample {
  Isosurface surface;
  particles::Particles points;

  Sample(const std::string& name, int nodes, std::uint64_t seed) : surface(sample_phantom(phantom(name), nodes), 0.0) {
    Monitor monitor;
    const TriangleMesh lattice_mesh = marching_cubes(surface, monitor);
    const SizingField field(surface.voxel());
    const particles::SizedSurface sized(surface, field);
    const auto count = static_cast<std::size_t>(particles::ideal_count(sized, lattice_mesh));
    auto seeds = particles::eliminate_to_seeds(sized, lattice_mesh, count, 4.0, seed, monitor);
    points = particles::make_particles(sized, std::move(seeds));
    particles::relax_by_newton(sized, points, 200, monitor);
  }
};

/// Rotates each triangle to start at its lowest corner and sorts all, so that equal surfaces give equal lists.
std::vector<Triangle> sorted(std::vector<Triangle> triangles) {
  for (Triangle& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

MeshFacts facts_of(const std::vector<Eigen::Vector3d>& points, const std::vector<Triangle>& triangles) {
  TriangleMesh mesh;
  mesh.vertices = points;
  mesh.triangles = triangles;
  return mesh_facts(mesh);
}

struct Case {
  std::string phantom;
  int nodes;
  std::uint64_t seed;
};

class TightCoconeOf : public testing::TestWithParam<Case> {};

// These samples have no slivers; see the next test.
TEST_P(TightCoconeOf, IsTheLabelledDelaunaySurfaceOfADenseSample) {
  const Sample sample(GetParam().phantom, GetParam().nodes, GetParam().seed);
  Monitor monitor;
  const TightCocone by_poles = tight_cocone(sample.points.points, monitor);
  const TightCocone by_gradient = tight_cocone(sample.points.points, sample.points.normals, monitor);
  const auto labelled = sorted(LabelledDelaunay(sample.points.points, sample.surface, monitor).triangles());
  EXPECT_EQ(sorted(by_poles.triangles), labelled);
  EXPECT_EQ(sorted(by_gradient.triangles), labelled);
  EXPECT_EQ(by_poles.bad, 0U);
  EXPECT_EQ(by_poles.conflicts, 0U);
  const MeshFacts facts = facts_of(sample.points.points, by_poles.triangles);
  EXPECT_EQ(facts.open_edges, 0U);
  EXPECT_EQ(facts.euler, phantom(GetParam().phantom).euler);
}

INSTANTIATE_TEST_SUITE_P(Phantoms, TightCoconeOf, testing::Values(Case{"ellipsoid", 40, 13}, Case{"torus", 28, 15}),
                         [](const auto& chosen) { return chosen.param.phantom; });

// Four points close to a circle span a sliver, all of whose facets are cocone facets. The walk keeps the outer two
// facets, the labels may keep the inner two. All differences must be such slivers.
TEST(TightCocone, DiffersFromTheLabelledDelaunaySurfaceInSliversOnly) {
  for (const char* name : {"ellipsoid", "torus"}) {
    const Sample sample(name, 40, 1);
    Monitor monitor;
    const auto labelled = sorted(LabelledDelaunay(sample.points.points, sample.surface, monitor).triangles());
    const auto closed = sorted(tight_cocone(sample.points.points, monitor).triangles);
    std::vector<Triangle> differing;
    std::set_symmetric_difference(closed.begin(), closed.end(), labelled.begin(), labelled.end(),
                                  std::back_inserter(differing));
    EXPECT_LT(static_cast<double>(differing.size()), 0.01 * static_cast<double>(labelled.size())) << name;
    const DelaunayCells cells = delaunay_cells(sample.points.points);
    std::size_t in_slivers = 0;
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
      std::size_t found = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        const auto [a, b, c] = cells.facet(cell, i);
        for (const Triangle& t : sorted({{a, b, c}, {a, c, b}})) {
          found += std::binary_search(differing.begin(), differing.end(), t) ? 1 : 0;
        }
      }
      in_slivers += found == 4 ? 4 : 0;
    }
    EXPECT_EQ(in_slivers, differing.size()) << name;
  }
}

TEST(PoleNormals, AreTheSurfacesOwnWhereItIsSampledDensely) {
  const Sample sample("torus", 40, 1);
  const auto normals = pole_normals(delaunay_cells(sample.points.points), sample.points.points);
  for (std::size_t p = 0; p < normals.size(); ++p) {
    // The error of a pole is about the sampling distance over the feature size, which is about 1/10 here.
    ASSERT_GT(std::abs(normals[p].dot(sample.points.normals[p])), 0.98);
  }
}

TEST(Cocone, FindsADenseSampleFlatEverywhere) {
  const Sample sample("ellipsoid", 40, 1);
  const DelaunayCells cells = delaunay_cells(sample.points.points);
  const Cocone found = cocone(cells, sample.points.points, sample.points.normals);
  EXPECT_EQ(std::count(found.flat.begin(), found.flat.end(), 0), 0);
  EXPECT_GE(found.facets.size(), 2 * sample.points.size() - 4);
}

// The purpose of the method: a hole in the sample is closed.
TEST(TightCocone, ClosesAHoleInTheSample) {
  const Sample sample("ellipsoid", 40, 1);
  const Eigen::Vector3d centre = sample.points.points.front();
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3d& x : sample.points.points) {
    if ((x - centre).norm() > 4.0 * sample.surface.voxel()) points.push_back(x);
  }
  ASSERT_LT(points.size(), sample.points.size() - 20);
  Monitor monitor;
  const TightCocone closed = tight_cocone(points, monitor);
  const MeshFacts facts = facts_of(points, closed.triangles);
  EXPECT_EQ(facts.open_edges, 0U);
  EXPECT_EQ(facts.euler, 2);
  const MeshFacts whole =
      facts_of(sample.points.points, LabelledDelaunay(sample.points.points, sample.surface, monitor).triangles());
  EXPECT_NEAR(facts.volume / whole.volume, 1.0, 0.02);
}

// Two balls, one of them hollow. Each surface is separate, and the cavity's surface is oriented inwards.
TEST(TightCocone, KeepsPartsAndCavitiesApart) {
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals;
  const auto add_sphere = [&](const Eigen::Vector3d& centre, double radius, std::size_t count) {
    for (std::size_t n = 0; n < count; ++n) {  // a Fibonacci lattice
      const double z = 1.0 - (2.0 * static_cast<double>(n) + 1.0) / static_cast<double>(count);
      const double turn = 2.399963229728653 * static_cast<double>(n);
      const double r = std::sqrt(1.0 - z * z);
      normals.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
      points.push_back(centre + radius * normals.back());
    }
  };
  add_sphere({0, 0, 0}, 2.0, 2000);
  add_sphere({0, 0, 0}, 1.0, 1000);
  add_sphere({5, 0, 0}, 1.0, 1000);
  Monitor monitor;
  for (const TightCocone& closed : {tight_cocone(points, monitor), tight_cocone(points, normals, monitor)}) {
    const MeshFacts facts = facts_of(points, closed.triangles);
    EXPECT_EQ(facts.components, 3U);
    EXPECT_EQ(facts.open_edges, 0U);
    EXPECT_EQ(facts.euler, 6);
    const double exact = 4.0 / 3.0 * std::acos(-1.0) * (8.0 - 1.0 + 1.0);
    EXPECT_NEAR(facts.volume / exact, 1.0, 0.01);
  }
}

TEST(TightCocone, ClosesWhateverItIsGiven) {
  std::vector<Eigen::Vector3d> cloud;
  for (std::size_t n = 0; n < 500; ++n) {
    cloud.emplace_back(uniform_random(1, n, 0), uniform_random(1, n, 1), uniform_random(1, n, 2));
  }
  Monitor monitor;
  const TightCocone closed = tight_cocone(cloud, monitor);
  EXPECT_GT(closed.bad, 100U);
  EXPECT_EQ(facts_of(cloud, closed.triangles).open_edges, 0U);
  EXPECT_THROW(tight_cocone({{1, 1, 5}, {2, 1, 5}, {1, 2, 5}, {2, 2, 5}}, monitor), Error);
}

}  // namespace
}  // namespace isobench
