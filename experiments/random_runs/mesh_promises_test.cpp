#include "isobench/experiments/random_runs/mesh_promises.h"

#include <gtest/gtest.h>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/experiments/runner/cell.h"
#include "isobench/methods/lattice/marching_cubes.h"
#include "isobench/methods/method.h"

namespace isobench {
namespace {

// The promises that a mesh of marching cubes would break if `particles` had made it.
std::vector<std::string> broken_by_marching_cubes(const std::string& phantom, void (*change)(TriangleMesh&)) {
  Monitor monitor;
  const Dataset dataset = load_dataset(phantom, monitor);
  TriangleMesh mesh = marching_cubes(*dataset.surface, monitor);
  change(mesh);
  RunRequest request;
  request.method = "particles";
  request.sizing.epsilon = 0.5;
  request.sizing.delta = 0.3;
  const MeshingTask task(*dataset.surface, request.sizing, {}, 1, dataset.topology);
  const auto sizing = task.sizing_field(monitor);
  return broken_promises(request, mesh,
                         measure(mesh, {dataset.surface.get(), sizing.get(), dataset.topology.get()}, monitor));
}

TEST(MeshPromises, AreBrokenByMeshesThatAreWrong) {
  const std::vector<std::string> shape = broken_by_marching_cubes("sphere", [](TriangleMesh&) {});
  ASSERT_EQ(shape.size(), 2U);
  EXPECT_EQ(shape[0].substr(0, 13), "has angles of");
  EXPECT_NE(shape[1].find("valences below 5 or above 7"), std::string::npos) << shape[1];
  const std::vector<std::string> open =
      broken_by_marching_cubes("sphere", [](TriangleMesh& mesh) { mesh.triangles.pop_back(); });
  ASSERT_EQ(open.size(), 4U);
  EXPECT_EQ(open[0], "is no closed manifold");
  EXPECT_EQ(open[1], "euler is 1 instead of 2");
}

}  // namespace
}  // namespace isobench
