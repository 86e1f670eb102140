// The method as a whole, on surfaces with known answers.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/isotropic-remeshing/remesh.h"
#include "isobench/methods/mesh/mesh_facts.h"
#include "isobench/methods/method.h"
#include "isobench/methods/testing/test_requests.h"

namespace isobench {
namespace {

TriangleMesh remeshed(const Isosurface& surface, const SizingRequest& request) {
  const Method& m = method("isotropic-remeshing");
  Monitor monitor;
  return m.mesh(MeshingTask(surface, request, Parameters(m.parameters), 1), monitor);
}

double mean_radius_ratio(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const double ab = (b - a).norm(), bc = (c - b).norm(), ca = (a - c).norm();
    const double double_area = (b - a).cross(c - a).norm();
    sum += 4.0 * double_area * double_area / (ab * bc * ca * (ab + bc + ca));
  }
  return sum / static_cast<double>(mesh.triangles.size());
}

TEST(IsotropicRemeshing, MeshesSphereTorusAndTwoBodies) {
  for (const char* name : {"sphere", "torus", "two-spheres"}) {
    SCOPED_TRACE(name);
    const Isosurface surface(sample_phantom(phantom(name), 40), 0.0);
    SizingRequest request;
    request.vertices = 2000;
    const TriangleMesh mesh = remeshed(surface, request);
    EXPECT_NEAR(static_cast<double>(mesh.vertices.size()), 2000.0, 40.0);
    const MeshFacts facts = mesh_facts(mesh);
    EXPECT_EQ(facts.open_edges, 0U);
    EXPECT_EQ(facts.nonmanifold_edges, 0U);
    EXPECT_EQ(facts.euler, phantom(name).euler);
    EXPECT_EQ(facts.components, static_cast<std::size_t>(phantom(name).components));
    EXPECT_GT(facts.volume, 0.0);
    EXPECT_GE(mean_radius_ratio(mesh), 0.95);
    for (const Eigen::Vector3d& x : mesh.vertices) {
      const Jet jet = surface.value_gradient(x);
      ASSERT_LT(std::abs(jet.value), 1e-5 * surface.voxel() * jet.gradient.norm());
    }
    EXPECT_EQ(mesh.vertices, remeshed(surface, request).vertices);
  }
}

// A cube whose faces do not share their corners, a triangle without area and an octahedron of the size of rounding, as
// marching cubes makes it around a node: corners are joined, the others dropped.
TEST(IsotropicRemeshing, JoinsCornersAtOnePlace) {
  TriangleMesh cube;
  const auto face = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                        const Eigen::Vector3d& d) {
    const auto first = static_cast<std::uint32_t>(cube.vertices.size());
    cube.vertices.insert(cube.vertices.end(), {a, b, c, d});
    cube.triangles.insert(cube.triangles.end(), {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
  };
  face({0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0});
  face({0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1});
  face({0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1});
  face({0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0});
  face({0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0});
  face({1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1});
  cube.triangles.push_back({0, 8, 16});  // three corners at one point
  constexpr double tiny = 4.5e-16;
  const auto first = static_cast<std::uint32_t>(cube.vertices.size());
  for (const double side : {-tiny, tiny}) {
    for (int axis = 0; axis < 3; ++axis)
      cube.vertices.emplace_back(Eigen::Vector3d(3, 3, 3) + side * Eigen::Vector3d::Unit(axis));
  }
  for (const Triangle& t :
       {Triangle{3, 4, 5}, {4, 0, 5}, {0, 1, 5}, {1, 3, 5}, {4, 3, 2}, {0, 4, 2}, {1, 0, 2}, {3, 1, 2}})
    cube.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  const TriangleMesh mesh = isotropic_remeshing::remesh(cube, 0.3, 3);
  const MeshFacts facts = mesh_facts(mesh);
  EXPECT_EQ(facts.open_edges, 0U);
  EXPECT_EQ(facts.euler, 2);
  EXPECT_GT(facts.volume, 0.5);
}

TEST(IsotropicRemeshing, SkipsASurfaceBetweenNodes) {
  for (const SizingRequest& request : {uniform(0.5), with_vertices(100)})
    EXPECT_THROW(remeshed(speck_between_nodes(), request), Skipped);
}

TEST(IsotropicRemeshing, SkipsAdaptiveSizingWithTheReason) {
  const Isosurface surface(sample_phantom(phantom("sphere"), 24), 0.0);
  SizingRequest request;
  request.epsilon = 0.5;
  request.delta = 0.3;
  try {
    remeshed(surface, request);
    FAIL();
  } catch (const Skipped& skipped) {
    EXPECT_NE(std::string(skipped.what()).find("edge_length or vertices"), std::string::npos);
  }
}

}  // namespace
}  // namespace isobench
