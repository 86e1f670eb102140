#include "isobench/methods/method.h"

#include "isobench/methods/lattice/marching_cubes.h"

namespace isobench {
namespace {

TriangleMesh mesh(const MeshingTask& task, Monitor& monitor) {
  if (!is_empty(task.sizing))
    monitor.note("marching-cubes: one vertex a crossed lattice edge; the sizing that was asked for has no effect");
  return marching_cubes(task.surface, monitor);
}

}  // namespace

Method method_marching_cubes() {
  Method method;
  method.name = "marching-cubes";
  method.summary =
      "Marching cubes at the lattice's own size, whatever the sizing, with vertices on F = c of the spline "
      "(Lorensen, Cline 1987, as in Meyer, Kirby, Whitaker 2007)";
  method.ignores_sizing = true;
  method.mesh = mesh;
  return method;
}

}  // namespace isobench
