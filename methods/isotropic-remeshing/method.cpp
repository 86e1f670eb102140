#include "isobench/methods/method.h"

#include <cmath>

#include "isobench/methods/isotropic-remeshing/remesh.h"
#include "isobench/methods/lattice/marching_cubes.h"

namespace isobench {
namespace isotropic_remeshing {
namespace {

class Remesher {
 public:
  Remesher(const MeshingTask& task, Monitor& monitor)
      : task_(task), monitor_(monitor), lattice_mesh_(marching_cubes(task.surface, monitor)) {
    if (lattice_mesh_.triangles.empty())
      throw Skipped("isotropic-remeshing: there is nothing to remesh, because the surface lies between the nodes");
  }

  TriangleMesh to_length(double edge_length) {
    monitor_.check();
    TriangleMesh mesh = remesh(lattice_mesh_, edge_length, task_.parameters.integer("iterations"));
    // Project once, at the end. Where the lattice joins sheets that F = c keeps apart, projecting after every move
    // would pull vertices from one sheet to the other and back.
    std::size_t failed = 0;
    for (Eigen::Vector3d& x : mesh.vertices) {
      const auto foot = task_.surface.project(x);
      failed += foot ? 0U : 1U;
      x = foot.value_or(x);
    }
    monitor_.set("isotropic-remeshing/length", edge_length);
    monitor_.set("isotropic-remeshing/not projected", static_cast<double>(failed));
    return mesh;
  }

  /// Varies the length until the number of vertices is within 1.5 % of the requested one. The tolerance cannot be much
  /// smaller: nearly equal lengths give numbers that differ by about 1 %.
  TriangleMesh to_number(double edge_length, double vertices) {
    constexpr double tolerance = 0.015;
    constexpr double usual = 1.08;  // target length over that of as many equilateral triangles; from spheres and tori
    constexpr int most = 8;
    edge_length *= usual;
    TriangleMesh mesh = to_length(edge_length);
    int tries = 1;
    for (; tries < most; ++tries) {
      const double share = static_cast<double>(mesh.vertices.size()) / vertices;
      if (std::abs(share - 1.0) <= tolerance) break;
      edge_length *= std::sqrt(share);
      mesh = to_length(edge_length);
    }
    monitor_.set("isotropic-remeshing/tries", tries);
    return mesh;
  }

 private:
  const MeshingTask& task_;
  Monitor& monitor_;
  TriangleMesh lattice_mesh_;
};

TriangleMesh mesh(const MeshingTask& task, Monitor& monitor) {
  if (!task.sizing.uniform()) {
    throw Skipped(
        "isotropic-remeshing: this method remeshes to one edge length everywhere; ask for edge_length or vertices "
        "instead of epsilon and delta");
  }
  Remesher remesher(task, monitor);
  const double edge_length = task.sizing_field(monitor)->largest();
  const auto stage = monitor.stage("remeshing");
  TriangleMesh mesh =
      task.sizing.vertices ? remesher.to_number(edge_length, *task.sizing.vertices) : remesher.to_length(edge_length);
  if (mesh.triangles.empty()) throw Skipped("isotropic-remeshing: nothing is left at this edge length");
  return mesh;
}

}  // namespace
}  // namespace isotropic_remeshing

Method method_isotropic_remeshing() {
  Method method;
  method.name = "isotropic-remeshing";
  method.revision = 2;
  method.summary =
      "Marching cubes, then CGAL's isotropic remeshing to one edge length, then projection of the vertices to F = c "
      "(Botsch, Kobbelt 2004); uniform sizing only";
  method.parameters = {
      {"iterations", 5.0, "", "rounds of splits, collapses, flips and relaxation", 1.0, 100.0, {}, true}};
  method.mesh = isotropic_remeshing::mesh;
  return method;
}

}  // namespace isobench
