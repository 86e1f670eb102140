// What CGAL's methods reach on a real volume: a bone one or two voxels thick, whose two shells the lattice joins. The
// expected figures were measured on CGAL's own programs at about 50,000 vertices.

#include <gtest/gtest.h>

#include <cstdlib>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/methods/method.h"
#include "isobench/metrics/topology/topology.h"

namespace isobench {
namespace {

const Isosurface* skull_small() {
  if (std::getenv("ISOBENCH_DATA") == nullptr) return nullptr;
  Monitor monitor;
  static const Dataset dataset = load_dataset("skull-small", monitor);
  return dataset.surface.get();
}

Measurement measured(const std::string& name, const std::map<std::string, ParameterValue>& values) {
  const Method& method = isobench::method(name);
  Parameters parameters(method.parameters);
  for (const auto& [key, value] : values) parameters.set(method.parameters, key, value);
  SizingRequest sizing;
  sizing.vertices = 50000;
  const MeshingTask task(*skull_small(), sizing, std::move(parameters), 1);
  Monitor monitor;
  TriangleMesh mesh = method.mesh(task, monitor);
  return measure(mesh, *skull_small(), *task.sizing_field(monitor), monitor);
}

void expect_both_shells(const Measurement& found, double average) {
  EXPECT_NEAR(found.number("vertices"), 50000.0, 1000.0);
  EXPECT_NEAR(found.number("radius_ratio_avg"), average, 0.01);
  EXPECT_GE(found.number("angle_min"), 30.0 - 1e-9);
  EXPECT_EQ(found.number("euler"), 0.0);
  EXPECT_EQ(found.number("components"), 2.0);
  EXPECT_TRUE(is_closed_manifold(found));
  EXPECT_LT(found.number("distance_vertex_max"), 1e-5 * skull_small()->voxel());
}

constexpr const char* needs = "needs the real volumes: set ISOBENCH_DATA to the folder that holds them";

TEST(CgalMethodsOnVolumes, Mesh3MeshesBothShellsOfTheSmallSkull) {
  if (skull_small() == nullptr) GTEST_SKIP() << needs;
  expect_both_shells(measured("delaunay-refinement", {}), 0.909);
}

TEST(CgalMethodsOnVolumes, Mesh3InParallelDoes) {
  if (skull_small() == nullptr) GTEST_SKIP() << needs;
  expect_both_shells(measured("delaunay-refinement", {{"parallel", true}}), 0.908);
}

TEST(CgalMethodsOnVolumes, SurfaceMesherDoes) {
  if (skull_small() == nullptr) GTEST_SKIP() << needs;
  expect_both_shells(measured("delaunay-refinement", {{"engine", std::string("surface-mesher")}}), 0.916);
}

// It keeps the false bridges that lattice marching cubes makes between the shells.
TEST(CgalMethodsOnVolumes, IsotropicRemeshingKeepsTheLatticesTopology) {
  if (skull_small() == nullptr) GTEST_SKIP() << needs;
  const Measurement found = measured("isotropic-remeshing", {});
  EXPECT_NEAR(found.number("vertices"), 50000.0, 1000.0);
  EXPECT_NEAR(found.number("radius_ratio_avg"), 0.963, 0.01);
  EXPECT_EQ(found.number("euler"), -8.0);
  EXPECT_EQ(found.number("components"), 1.0);
  EXPECT_TRUE(is_closed_manifold(found));
}

}  // namespace
}  // namespace isobench
