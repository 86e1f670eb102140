// The method as a whole, on surfaces with known answers.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/advancing-front/advance.h"
#include "isobench/methods/advancing-front/seeds.h"
#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/mesh/mesh_facts.h"
#include "isobench/methods/method.h"
#include "isobench/methods/testing/test_requests.h"

namespace isobench {
namespace {

TriangleMesh front_mesh_of(const Isosurface& surface, const SizingRequest& request, Monitor& monitor,
                           std::uint64_t seed = 1, const std::string& guidance = "shared") {
  const Method& m = method("advancing-front");
  Parameters parameters(m.parameters);
  parameters.set(m.parameters, "guidance", guidance);
  return m.mesh(MeshingTask(surface, request, parameters, seed), monitor);
}

double mean_radius_ratio(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const double ab = (b - a).norm(), bc = (c - b).norm(), ca = (a - c).norm();
    const double double_area = (b - a).cross(c - a).norm();
    sum += 4.0 * double_area * double_area / (ab * bc * ca * (ab + bc + ca));  // 2 r_in/r_circ
  }
  return sum / static_cast<double>(mesh.triangles.size());
}

/// Mean and largest of edge length over `length(middle)`.
template <typename Length>
std::pair<double, double> edges_over(const TriangleMesh& mesh, const Length& length) {
  double sum = 0.0, largest = 0.0;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d &a = mesh.vertices[t[k]], &b = mesh.vertices[t[(k + 1) % 3]];
      const double ratio = (a - b).norm() / length(0.5 * (a + b));
      sum += ratio;
      largest = std::max(largest, ratio);
    }
  }
  return {sum / (3.0 * static_cast<double>(mesh.triangles.size())), largest};
}

void expect_counts_to_add_up(const Monitor& monitor, const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const char* kind : {"seed", "grown", "connected", "split", "merged", "failsafe"}) {
    sum += monitor.counters().at(std::string("advancing-front/") + kind);
  }
  EXPECT_EQ(sum, static_cast<double>(mesh.triangles.size()));
}

class AdvancingFrontPhantom : public testing::TestWithParam<Phantom> {};

TEST_P(AdvancingFrontPhantom, IsClosedOfTheRightTopologyAndWellShaped) {
  const Phantom& p = GetParam();
  const Isosurface surface(sample_phantom(p, 56), 0.0);
  Monitor monitor;
  const TriangleMesh mesh = front_mesh_of(surface, adaptive(0.4, 0.3), monitor);
  const MeshFacts facts = mesh_facts(mesh);
  EXPECT_EQ(facts.open_edges, 0U);
  EXPECT_EQ(facts.nonmanifold_edges, 0U);
  EXPECT_EQ(facts.euler, p.euler);
  EXPECT_EQ(facts.components, static_cast<std::size_t>(p.components));
  EXPECT_GT(facts.volume, 0.0);
  EXPECT_GE(mean_radius_ratio(mesh), 0.93);
  for (const Eigen::Vector3d& x : mesh.vertices) {
    const Jet jet = surface.value_gradient(x);
    ASSERT_LT(std::abs(jet.value) / jet.gradient.norm(), 2e-6 * surface.voxel());
  }
  expect_counts_to_add_up(monitor, mesh);
}

INSTANTIATE_TEST_SUITE_P(Phantoms, AdvancingFrontPhantom, testing::ValuesIn(phantoms()), [](const auto& instance) {
  std::string name = instance.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(AdvancingFront, EdgesAreAsLongAsAskedOnAverage) {
  const Isosurface surface = surface_of("torus", 64);
  const double length = 1.3 * surface.voxel();
  Monitor monitor;
  const TriangleMesh mesh = front_mesh_of(surface, uniform(length), monitor);
  const auto [mean, largest] = edges_over(mesh, [&](const Eigen::Vector3d&) { return length; });
  EXPECT_NEAR(mean, 1.0, 0.05);
  EXPECT_LT(largest, 2.0);  // a connected vertex is at most two edge lengths from the middle of its edge
  EXPECT_GE(mean_radius_ratio(mesh), 0.95);
}

TEST(AdvancingFront, EdgesFollowTheSharedFieldOverTheContraction) {
  const Isosurface surface = surface_of("ellipsoid", 64);
  const SizingRequest request = adaptive(0.25, 0.3);
  Monitor monitor;
  const SizingField field = make_sizing_field(surface, request, monitor);
  const TriangleMesh mesh = front_mesh_of(surface, request, monitor);
  EXPECT_NEAR(edges_over(mesh, [&](const Eigen::Vector3d& x) { return field.h(x) / 1.5; }).first, 1.0, 0.05);
}

TEST(AdvancingFront, ItsOwnGuidanceClosesToo) {
  const Isosurface surface = surface_of("torus", 40);
  Monitor monitor;
  const TriangleMesh mesh = front_mesh_of(surface, adaptive(0.5, 0.3), monitor, 1, "own");
  const MeshFacts facts = mesh_facts(mesh);
  EXPECT_EQ(facts.open_edges, 0U);
  EXPECT_EQ(facts.euler, 0);
  EXPECT_GE(mean_radius_ratio(mesh), 0.93);
  EXPECT_EQ(monitor.seconds("sizing"), 0.0);  // the shared field was not computed
}

bool same_bytes(const TriangleMesh& a, const TriangleMesh& b) {
  return a.vertices == b.vertices && a.triangles == b.triangles;
}

TEST(AdvancingFront, TheSameSeedGivesTheSameBytesForAnyNumberOfThreads) {
  const Isosurface surface = surface_of("two-spheres", 40);
  for (const char* guidance : {"shared", "own"}) {
    TriangleMesh first;
    for (const std::size_t threads : {1U, 2U, 4U}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      Monitor monitor;
      const TriangleMesh mesh = front_mesh_of(surface, adaptive(0.5, 0.3), monitor, 7, guidance);
      if (threads == 1U) first = mesh;
      EXPECT_TRUE(same_bytes(mesh, first)) << guidance << ", threads " << threads;
    }
    Monitor monitor;
    EXPECT_FALSE(same_bytes(front_mesh_of(surface, adaptive(0.5, 0.3), monitor, 8, guidance), first)) << guidance;
  }
}

TEST(AdvancingFront, StartsOnEveryComponentHoweverSmall) {
  // A ball, and a grain of about one voxel, much smaller than the requested edges.
  FloatVolume v;
  v.lattice.size = {40, 24, 24};
  v.samples.resize(v.lattice.nodes());
  for (int k = 0; k < 24; ++k) {
    for (int j = 0; j < 24; ++j) {
      for (int i = 0; i < 40; ++i) {
        const Eigen::Vector3d x(i, j, k);
        const double ball = 7.0 - (x - Eigen::Vector3d(12.1, 12.2, 11.9)).norm();
        const double grain = 1.2 - (x - Eigen::Vector3d(32.2, 12.1, 12.0)).norm();
        v.at(i, j, k) = static_cast<float>(std::max({ball, grain, -3.0}));
      }
    }
  }
  Monitor monitor;
  const TriangleMesh mesh = front_mesh_of(Isosurface(v, 0.0), uniform(2.0), monitor);
  const MeshFacts facts = mesh_facts(mesh);
  EXPECT_EQ(facts.components, 2U);
  EXPECT_EQ(facts.euler, 4);
  EXPECT_EQ(facts.open_edges, 0U);
}

TEST(AdvancingFront, MeshesGrainsBesideALargerSurface) {
  // A ball, and grains of about two voxels at a distance of one or two voxels from it; edges are longer than the
  // grains.
  FloatVolume v;
  v.lattice.size = {40, 24, 24};
  v.samples.resize(v.lattice.nodes());
  for (int k = 0; k < 24; ++k) {
    for (int j = 0; j < 24; ++j) {
      for (int i = 0; i < 40; ++i) {
        const Eigen::Vector3d x(i, j, k);
        const double ball = 9.0 - (x - Eigen::Vector3d(12.1, 12.2, 11.9)).norm();
        double f = ball;
        for (const double side : {-3.5, 0.0, 3.5}) {
          f = std::max(f, 0.9 - (x - Eigen::Vector3d(23.0, 12.0 + side, 12.0)).norm());
        }
        v.at(i, j, k) = static_cast<float>(std::max(f, -3.0));
      }
    }
  }
  const Isosurface surface(v, 0.0, Inside::above, Kernel::interpolating_bspline);
  Monitor monitor;
  const TriangleMesh mesh = front_mesh_of(surface, uniform(4.0), monitor);
  const MeshFacts facts = mesh_facts(mesh);
  EXPECT_EQ(facts.components, 4U);
  EXPECT_EQ(facts.euler, 8);
  EXPECT_EQ(facts.open_edges, 0U);
  EXPECT_EQ(monitor.counters().at("advancing-front/lost components"), 0.0);
  expect_counts_to_add_up(monitor, mesh);
}

TEST(AdvancingFront, ReachesSheetsThatTheLatticeJoinsToOthers) {
  // A hollow ball with a shell so thin that the lattice's mesh has holes in it: marching cubes gives one component
  // where F = c has two, as in the bone of a skull.
  FloatVolume v;
  v.lattice.size = {28, 28, 28};
  v.samples.resize(v.lattice.nodes());
  for (int k = 0; k < 28; ++k) {
    for (int j = 0; j < 28; ++j) {
      for (int i = 0; i < 28; ++i) {
        const double r = (Eigen::Vector3d(i, j, k) - Eigen::Vector3d(13.4, 13.6, 13.5)).norm();
        v.at(i, j, k) = static_cast<float>(0.6 - std::abs(r - 8.3));
      }
    }
  }
  const Isosurface surface(v, 0.0, Inside::above, Kernel::interpolating_bspline);
  Monitor monitor;
  ASSERT_EQ(mesh_facts(marching_cubes(surface, monitor)).components, 1U);
  const TriangleMesh mesh = front_mesh_of(surface, uniform(1.0), monitor);
  const MeshFacts facts = mesh_facts(mesh);
  EXPECT_EQ(facts.components, 2U);
  EXPECT_EQ(facts.euler, 4);
  EXPECT_EQ(facts.open_edges, 0U);
}

TEST(AdvancingFront, ReportsEveryPlaceThatTheFailsafeHadToClose) {
  // Edges as long as the radius of the tubes: the front cannot close everywhere without the failsafe.
  const Isosurface surface = surface_of("gyroid-ball", 64);
  Monitor monitor;
  const TriangleMesh mesh = front_mesh_of(surface, uniform(5.0 * surface.voxel()), monitor);
  const auto holes = static_cast<std::size_t>(monitor.counters().at("advancing-front/holes"));
  EXPECT_GT(holes, 0U);
  EXPECT_GT(monitor.counters().at("advancing-front/failsafe"), 0.0);
  const auto& notes = monitor.notes();
  EXPECT_EQ(static_cast<std::size_t>(
                std::count_if(notes.begin(), notes.end(),
                              [](const std::string& note) { return note.find("the failsafe") != std::string::npos; })),
            holes);
  expect_counts_to_add_up(monitor, mesh);
  EXPECT_EQ(mesh_facts(mesh).nonmanifold_edges, 0U);
}

TEST(AdvancingFront, SkipsAnObjectThatLeavesTheVolume) {
  FloatVolume v;
  v.lattice.size = {8, 8, 8};
  v.samples.resize(v.lattice.nodes());
  for (int k = 0; k < 8; ++k) {
    for (int j = 0; j < 8; ++j) {
      for (int i = 0; i < 8; ++i) v.at(i, j, k) = static_cast<float>(k) - 3.6F;
    }
  }
  const Isosurface surface(v, 0.0);
  Monitor monitor;
  EXPECT_THROW(front_mesh_of(surface, uniform(1.0), monitor), Skipped);
}

TEST(AdvancingFront, StopsWhenCancelled) {
  const Isosurface surface = surface_of("sphere", 32);
  Monitor monitor;
  monitor.cancel();
  EXPECT_THROW(front_mesh_of(surface, uniform(2.0), monitor), Cancelled);
}

TEST(AdvancingFront, StopsAtTheMostTriangles) {
  using namespace advancing_front;
  const Isosurface surface(sample_phantom(phantom("sphere"), 32), 0.0);
  const Step step = [&surface](const Eigen::Vector3d&) { return 2.0 * surface.voxel(); };
  Monitor monitor;
  const Eigen::Vector3d start = marching_cubes(surface, monitor).vertices[0];
  const auto triangles = [&](std::size_t most) {
    Front front(2.0 * surface.voxel());
    Counts counts;
    Advance advance(surface, step, front, counts, {Eigen::Vector3d::Zero(), surface.extent()}, most);
    advance.add_loop(front.seed(seed_triangle(surface, step, start, 1).value()));
    advance.run(monitor);
    EXPECT_EQ(advance.is_endless(), front.triangles().size() >= most);
    return front.triangles().size();
  };
  const std::size_t all = triangles(100000);
  EXPECT_GT(all, 100U);
  EXPECT_LT(all, 100000U);
  EXPECT_GE(triangles(50), 50U);
  EXPECT_LE(triangles(50), 52U);
}

}  // namespace
}  // namespace isobench
