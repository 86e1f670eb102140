#include "isobench/methods/method.h"

#include "isobench/methods/lattice/marching_cubes.h"

namespace isobench {
namespace {

TriangleMesh mesh(const MeshingTask& task, Monitor& monitor) {
  if (!is_empty(task.sizing))
    monitor.note("marching-cubes: one vertex per crossed lattice edge; the requested sizing has no effect");
  return marching_cubes(task.surface, monitor);
}

}  // namespace

Method method_marching_cubes() {
  Method method;
  method.name = "marching-cubes";
  method.summary =
      "Marching cubes with vertices on the spline's F = c (Lorensen, Cline 1987, as in Meyer, Kirby, Whitaker 2007); "
      "triangles have the lattice's size, any sizing is ignored";
  method.ignores_sizing = true;
  method.mesh = mesh;
  return method;
}

}  // namespace isobench
