// What `cvt` must reach on a real volume: a bone one or two voxels thick, whose two shells the lattice joins.

#include <gtest/gtest.h>

#include <cstdlib>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/methods/method.h"
#include "isobench/metrics/measurement.h"

namespace isobench {
namespace {

TEST(CvtOnVolumes, MeshesBothShellsOfTheSmallSkull) {
  if (std::getenv("ISOBENCH_DATA") == nullptr) {
    GTEST_SKIP() << "needs the real volumes: set ISOBENCH_DATA to the folder that holds them";
  }
  Monitor monitor;
  const Dataset dataset = load_dataset("skull-small", monitor);
  // With 10,000 vertices the edges are longer than the bone is thick; there the cure adds sites.
  struct Wanted {
    double vertices;
    double least;
    double average;
    double off;  ///< relative tolerance of the number of vertices
  };
  for (const Wanted& wanted : {Wanted{50000.0, 0.55, 0.975, 0.0}, Wanted{10000.0, 0.5, 0.975, 0.05}}) {
    SCOPED_TRACE(wanted.vertices);
    SizingRequest sizing;
    sizing.vertices = wanted.vertices;
    const Method& method = isobench::method("cvt");
    const MeshingTask task(*dataset.surface, sizing, Parameters(method.parameters), 1);
    TriangleMesh mesh = method.mesh(task, monitor);
    const Measurement found = measure(mesh, *dataset.surface, *task.sizing_field(monitor), monitor);
    EXPECT_NEAR(static_cast<double>(mesh.vertices.size()), wanted.vertices, wanted.off * wanted.vertices);
    EXPECT_GE(found.number("radius_ratio_avg"), wanted.average);
    EXPECT_GE(found.number("radius_ratio_min"), wanted.least);
    EXPECT_EQ(found.number("euler"), 0.0);
    EXPECT_EQ(found.number("components"), 2.0);
    EXPECT_EQ(found.number("boundary_edges"), 0.0);
    EXPECT_EQ(found.number("nonmanifold_edges"), 0.0);
    EXPECT_EQ(found.number("self_intersections"), 0.0);
  }
}

}  // namespace
}  // namespace isobench
