// Tests of the whole method on surfaces with known answers.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/methods/mesh/mesh_facts.h"
#include "isobench/methods/method.h"
#include "isobench/methods/testing/test_requests.h"

namespace isobench {
namespace {

TriangleMesh cvt_mesh_of(const Isosurface& surface, const SizingRequest& request, Monitor& monitor,
                         std::uint64_t seed = 1) {
  const Method& m = method("cvt");
  return m.mesh(MeshingTask(surface, request, Parameters(m.parameters), seed), monitor);
}

/// Mean and minimum of 2 r_in/r_circ.
std::pair<double, double> radius_ratios(const TriangleMesh& mesh) {
  double sum = 0.0, least = 1.0;
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const double ab = (b - a).norm(), bc = (c - b).norm(), ca = (a - c).norm();
    const double double_area = (b - a).cross(c - a).norm();
    const double ratio = 4.0 * double_area * double_area / (ab * bc * ca * (ab + bc + ca));
    sum += ratio;
    least = std::min(least, ratio);
  }
  return {sum / static_cast<double>(mesh.triangles.size()), least};
}

void expect_closed(const TriangleMesh& mesh, const Phantom& p) {
  const MeshFacts facts = mesh_facts(mesh);
  EXPECT_EQ(facts.open_edges, 0U) << p.name;
  EXPECT_EQ(facts.nonmanifold_edges, 0U) << p.name;
  EXPECT_EQ(facts.euler, p.euler) << p.name;
  EXPECT_EQ(facts.components, static_cast<std::size_t>(p.components)) << p.name;
  EXPECT_GT(facts.volume, 0.0) << p.name;
}

TEST(CvtMethod, MeshesPhantomsClosedAndWellShaped) {
  for (const Phantom& p : phantoms()) {
    SCOPED_TRACE(p.name);
    const Isosurface surface(sample_phantom(p, 56), 0.0);
    Monitor monitor;
    const TriangleMesh mesh = cvt_mesh_of(surface, adaptive(0.4, 0.3), monitor);
    expect_closed(mesh, p);
    const auto [mean, least] = radius_ratios(mesh);
    EXPECT_GE(mean, 0.97);
    EXPECT_GE(least, 0.5);
  }
}

// The edges are longer than the sheets are thick and apart, so the cure adds sites. h is made smaller around them;
// otherwise the triangles there would stay bad.
TEST(CvtMethod, RefinesWhereSheetsAreNearerThanTheEdgesAreLong) {
  const Isosurface surface = surface_of("thin-sheets", 96);
  SizingRequest request;
  request.edge_length = 2.0;
  Monitor monitor;
  const TriangleMesh mesh = cvt_mesh_of(surface, request, monitor);
  expect_closed(mesh, phantom("thin-sheets"));
  EXPECT_GT(monitor.counters().at("cvt/inserted"), 0.0);
  EXPECT_GT(monitor.counters().at("cvt/rounds"), 0.0);
  EXPECT_GE(radius_ratios(mesh).first, 0.95);
}

TEST(CvtMethod, HasTheVerticesAskedFor) {
  SizingRequest request;
  request.vertices = 3000;
  Monitor monitor;
  const TriangleMesh mesh = cvt_mesh_of(surface_of("torus", 48), request, monitor);
  EXPECT_EQ(mesh.vertices.size(), 3000U);
  EXPECT_GE(radius_ratios(mesh).first, 0.98);
}

TEST(CvtMethod, IsTheSameForAnyNumberOfThreadsAndAnotherForAnotherSeed) {
  const Isosurface surface = surface_of("two-spheres", 40);
  TriangleMesh first;
  for (const std::size_t threads : {1U, 2U, 4U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Monitor monitor;
    const TriangleMesh mesh = cvt_mesh_of(surface, adaptive(0.5, 0.3), monitor, 7);
    if (threads == 1U) first = mesh;
    EXPECT_EQ(mesh.vertices, first.vertices) << threads;
    EXPECT_EQ(mesh.triangles, first.triangles) << threads;
  }
  Monitor monitor;
  EXPECT_NE(cvt_mesh_of(surface, adaptive(0.5, 0.3), monitor, 8).vertices, first.vertices);
}

}  // namespace
}  // namespace isobench
