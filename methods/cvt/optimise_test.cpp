#include "isobench/methods/cvt/optimise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/foundation/error.h"
#include "isobench/methods/closing/labelled_delaunay.h"
#include "isobench/methods/cvt/cells.h"
#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/particles/sampling/seeds.h"
#include "isobench/methods/testing/test_requests.h"

namespace isobench::cvt {
namespace {

/// Seeds on a phantom and their triangulation.
struct Case {
  Case(const std::string& name, int nodes, const SizingRequest& request, double contraction)
      : surface(sample_phantom(phantom(name), nodes), 0.0),
        field(make_sizing_field(surface, request, monitor)),
        sized(surface, field, contraction) {
    const TriangleMesh lattice_mesh = marching_cubes(surface, monitor);
    const auto count = static_cast<std::size_t>(particles::ideal_count(sized, lattice_mesh));
    sites =
        particles::make_particles(sized, particles::eliminate_to_seeds(sized, lattice_mesh, count, 4.0, 1, monitor));
  }

  Optimised run(const Iterations& iterations) {
    if (!mesh) mesh.emplace(LabelledDelaunay(sites.points, surface, monitor).triangles(), sites.size());
    return optimise(sized, sites, *mesh, iterations, monitor);
  }

  Cells cells() const { return voronoi_cells(sites.points, sites.spacing, mesh->triangles()); }

  Monitor monitor;
  Isosurface surface;
  SizingField field;
  particles::SizedSurface sized;
  particles::Particles sites;
  std::optional<DelaunayMesh> mesh;
};

// This holds if edges are short against the radii of curvature, because cells are parts of triangles, not of the
// surface.
TEST(CvtOptimise, LloydNeverRaisesTheEnergy) {
  for (const auto& request : {uniform(1.5), adaptive(0.15, 0.3)}) {
    for (const char* name : {"torus", "ellipsoid", "rounded-box"}) {
      Case c(name, 48, request, 1.0);
      // Compares the energy itself. The trace divides it by the energy of hexagons, which changes with the sites.
      double before = std::numeric_limits<double>::infinity();
      for (int iteration = 0; iteration < 20; ++iteration) {
        c.run({1, 0});
        const double now = c.cells().energy;
        EXPECT_LT(now, before) << name << ", iteration " << iteration;
        before = now;
      }
    }
  }
}

TEST(CvtOptimise, ComesNearTheEnergyOfHexagonsAndTheCentroids) {
  Case c("sphere", 48, uniform(1.5), 1.0);
  const Optimised done = c.run({10, 150});
  // A sphere cannot consist of hexagons only: at least twelve sites have five neighbours.
  EXPECT_GT(done.energy, 1.0);
  EXPECT_LT(done.energy, 1.015);
  EXPECT_EQ(done.energy, c.monitor.traces().at("energy").back());
  const Cells cells = c.cells();
  double square = 0.0;
  for (std::size_t n = 0; n < c.sites.size(); ++n) {
    const Eigen::Vector3d off = cells.centroids[n] - c.sites.points[n];
    square += (off - off.dot(c.sites.normals[n]) * c.sites.normals[n]).squaredNorm();
  }
  EXPECT_LT(std::sqrt(square / static_cast<double>(c.sites.size())), 0.01 * 1.5);
}

TEST(CvtOptimise, QuasiNewtonGetsFartherThanLloyd) {
  Case one("torus", 48, uniform(1.5), 1.0), other("torus", 48, uniform(1.5), 1.0);
  const Optimised lloyd = one.run({70, 0});
  const Optimised newton = other.run({10, 60});
  EXPECT_EQ(lloyd.lloyd, 70);
  EXPECT_EQ(newton.quasi_newton, 60);
  // Compares the parts above the energy of hexagons.
  EXPECT_LT(newton.energy - 1.0, 0.7 * (lloyd.energy - 1.0));
}

TEST(CvtOptimise, KeepsSitesOnTheSurface) {
  Case c("torus", 48, adaptive(0.4, 0.3), 1.5);
  c.run({5, 20});
  for (std::size_t n = 0; n < c.sites.size(); ++n) {
    const Jet jet = c.surface.value_gradient(c.sites.points[n]);
    EXPECT_LT(std::abs(jet.value) / jet.gradient.norm(), 2e-6 * c.surface.voxel());
    EXPECT_GT(c.sites.normals[n].dot(outward_normal(jet.gradient)), 1.0 - 1e-9);
    EXPECT_EQ(c.sites.spacing[n], c.sized.spacing(c.sites.points[n]));
  }
}

// Tests the exponent of the density: with 1/h² instead of 1/h⁴, edge lengths would be proportional to √h.
TEST(CvtOptimise, EdgesFollowTheSizing) {
  Case c("two-spheres", 64, adaptive(0.3, 0.3), 1.0);
  c.run({10, 150});
  std::vector<std::pair<double, double>> edges;  // h and the length divided by h
  for (const Triangle& t : c.mesh->triangles()) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double h = 0.5 * (c.sites.spacing[t[k]] + c.sites.spacing[t[(k + 1) % 3]]);
      edges.emplace_back(h, (c.sites.points[t[k]] - c.sites.points[t[(k + 1) % 3]]).norm() / h);
    }
  }
  std::sort(edges.begin(), edges.end());
  const std::size_t third = edges.size() / 3;
  double fine = 0.0, coarse = 0.0;
  for (std::size_t n = 0; n < third; ++n) {
    fine += edges[n].second / static_cast<double>(third);
    coarse += edges[edges.size() - 1 - n].second / static_cast<double>(third);
  }
  ASSERT_GT(edges[edges.size() - third].first, 1.5 * edges[third].first);
  EXPECT_NEAR(fine, 1.0, 0.07);
  EXPECT_NEAR(coarse, 1.0, 0.07);
}

TEST(CvtOptimise, StopsWhenCancelled) {
  Case c("sphere", 32, uniform(3.0), 1.0);
  DelaunayMesh mesh(LabelledDelaunay(c.sites.points, c.surface, c.monitor).triangles(), c.sites.size());
  c.monitor.cancel();
  EXPECT_THROW(optimise(c.sized, c.sites, mesh, {5, 5}, c.monitor), Cancelled);
}

}  // namespace
}  // namespace isobench::cvt
