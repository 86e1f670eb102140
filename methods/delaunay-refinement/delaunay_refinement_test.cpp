// The method as a whole, on surfaces with known answers.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/mesh/mesh_facts.h"
#include "isobench/methods/method.h"
#include "isobench/methods/testing/test_requests.h"

namespace isobench {
namespace {

using Values = std::map<std::string, ParameterValue>;

Parameters with(const Values& values) {
  const ParameterSchema& schema = method("delaunay-refinement").parameters;
  Parameters parameters(schema);
  for (const auto& [name, value] : values) parameters.set(schema, name, value);
  return parameters;
}

TriangleMesh refined_mesh_of(const Isosurface& surface, const SizingRequest& request, const Values& values = {},
                             std::uint64_t seed = 1) {
  Monitor monitor;
  return method("delaunay-refinement").mesh(MeshingTask(surface, request, with(values), seed), monitor);
}

double smallest_angle(const TriangleMesh& mesh) {
  double least = std::numbers::pi;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::Vector3d& x = mesh.vertices[t[c]];
      const Eigen::Vector3d a = mesh.vertices[t[(c + 1) % 3]] - x, b = mesh.vertices[t[(c + 2) % 3]] - x;
      least = std::min(least, std::atan2(a.cross(b).norm(), a.dot(b)));
    }
  }
  return least * 180.0 / std::numbers::pi;
}

void expect_right(const TriangleMesh& mesh, const Phantom& p, const Isosurface& surface) {
  const MeshFacts facts = mesh_facts(mesh);
  EXPECT_EQ(facts.open_edges, 0U);
  EXPECT_EQ(facts.nonmanifold_edges, 0U);
  EXPECT_EQ(facts.euler, p.euler);
  EXPECT_EQ(facts.components, static_cast<std::size_t>(p.components));
  EXPECT_GT(facts.volume, 0.0) << "turned inside out";
  EXPECT_GE(smallest_angle(mesh), 30.0 - 1e-9);
  for (const Eigen::Vector3d& x : mesh.vertices) {
    const Jet jet = surface.value_gradient(x);
    ASSERT_LT(std::abs(jet.value), 1e-5 * surface.voxel() * jet.gradient.norm());
  }
}

const std::vector<Values>& engines() {
  static const std::vector<Values> all = {{}, {{"parallel", true}}, {{"engine", std::string("surface-mesher")}}};
  return all;
}

TEST(DelaunayRefinement, MeshesSphereTorusAndTwoBodiesByEveryEngine) {
  for (const char* name : {"sphere", "torus", "two-spheres"}) {
    const Isosurface surface = surface_of(name, 40);
    for (std::size_t engine = 0; engine < engines().size(); ++engine) {
      SCOPED_TRACE(std::string(name) + ", engine " + std::to_string(engine));
      const TriangleMesh mesh = refined_mesh_of(surface, with_vertices(2000), engines()[engine]);
      expect_right(mesh, phantom(name), surface);
      EXPECT_NEAR(static_cast<double>(mesh.vertices.size()), 2000.0, 40.0);
    }
  }
}

// The mean edge length is within 3 % of the requested one, as on the spheres and tori by which the bound was set.
TEST(DelaunayRefinement, EdgesAreAsLongAsAskedForOnAverage) {
  const Isosurface surface = surface_of("torus", 48);
  SizingRequest request;
  request.edge_length = 1.0;
  for (const Values& engine : {Values{}, Values{{"engine", std::string("surface-mesher")}}}) {
    const TriangleMesh mesh = refined_mesh_of(surface, request, engine);
    double sum = 0.0;
    for (const Triangle& t : mesh.triangles) {
      for (std::size_t c = 0; c < 3; ++c) sum += (mesh.vertices[t[c]] - mesh.vertices[t[(c + 1) % 3]]).norm();
    }
    EXPECT_NEAR(sum / (3.0 * static_cast<double>(mesh.triangles.size())), 1.0, 0.03);
  }
}

TEST(DelaunayRefinement, FollowsTheFieldOfSizes) {
  const Isosurface surface = surface_of("torus", 48);
  SizingRequest request;
  request.epsilon = 0.4;
  request.delta = 0.3;
  for (const Values& engine : engines()) {
    const TriangleMesh mesh = refined_mesh_of(surface, request, engine);
    expect_right(mesh, phantom("torus"), surface);
  }
  // With g = 1.5, surface balls have a radius of about h/2. An edge is at most two radii long.
  Monitor monitor;
  const MeshingTask task(surface, request, with({}), 1);
  const TriangleMesh mesh = method("delaunay-refinement").mesh(task, monitor);
  const auto field = task.sizing_field(monitor);
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::Vector3d &a = mesh.vertices[t[c]], &b = mesh.vertices[t[(c + 1) % 3]];
      ASSERT_LT((a - b).norm(), 1.15 * 0.5 * (field->h(a) + field->h(b)));
    }
  }
}

TEST(DelaunayRefinement, ComesNearerWhereADistanceIsAskedFor) {
  const Isosurface surface = surface_of("torus", 48);
  const auto size = [&](double distance) {
    SizingRequest request;
    request.edge_length = 4.0;
    return refined_mesh_of(surface, request, {{"distance", distance}}).vertices.size();
  };
  EXPECT_GT(size(0.05), 2 * size(0.0));
}

TEST(DelaunayRefinement, IsTheSameForAnyNumberOfThreadsAndAnotherForAnotherSeed) {
  const Isosurface surface = surface_of("two-spheres", 40);
  const TriangleMesh first = refined_mesh_of(surface, with_vertices(2000));
  {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const TriangleMesh again = refined_mesh_of(surface, with_vertices(2000));
    EXPECT_EQ(first.vertices, again.vertices);
    EXPECT_EQ(first.triangles, again.triangles);
  }
  EXPECT_NE(first.vertices, refined_mesh_of(surface, with_vertices(2000), {}, 2).vertices);
}

TEST(DelaunayRefinement, PromisesTheSameMeshOfMesh3OnOneThreadAlone) {
  const Method& refinement = method("delaunay-refinement");
  EXPECT_TRUE(is_deterministic(refinement, with({})));
  EXPECT_FALSE(is_deterministic(refinement, with({{"parallel", true}})));
  EXPECT_FALSE(is_deterministic(refinement, with({{"engine", std::string("surface-mesher")}})));
  EXPECT_FALSE(is_deterministic(method("external"), Parameters(method("external").parameters)));
}

TEST(DelaunayRefinement, SaysWhatItCannotDo) {
  const Isosurface surface = surface_of("sphere", 24);
  try {
    refined_mesh_of(surface, with_vertices(500), {{"parallel", true}, {"engine", std::string("surface-mesher")}});
    FAIL();
  } catch (const Skipped& skipped) {
    EXPECT_NE(std::string(skipped.what()).find("surface-mesher has no parallel variant"), std::string::npos);
  }
  EXPECT_THROW(with({{"angle", 31.0}}), UsageError);
  EXPECT_THROW(with({{"engine", std::string("mesh-2")}}), UsageError);
}

TEST(DelaunayRefinement, CanBeStopped) {
  const Isosurface surface = surface_of("sphere", 24);
  for (const Values& engine : engines()) {
    Monitor monitor;
    const MeshingTask task(surface, with_vertices(1e6), with(engine), 1);
    const auto field = task.sizing_field(monitor);
    std::thread other([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
      monitor.cancel();
    });
    EXPECT_THROW(method("delaunay-refinement").mesh(task, monitor), Cancelled);
    other.join();
  }
}

}  // namespace
}  // namespace isobench
