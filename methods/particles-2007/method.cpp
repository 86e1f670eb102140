// The published pipeline, stage by stage. Its stages live with those of `particles`. In one respect it is more careful
// than what is printed, and says so: the medial axis, of which the paper itself says that the sampling can be no better
// than it, is sought near the surface from finer nodes than the lattice's, and its ends are not left out. With
// axis_ends = "left-out" and axis_halvings = 0 it is as printed.
#include "isobench/methods/method.h"

#include "isobench/methods/particles/pipeline.h"

namespace isobench {

Method method_particles_2007() {
  Method method;
  method.name = "particles-2007";
  method.summary =
      "Particles as published: foot-point medial axis, explicit limiter, Gauss-Seidel relaxation, Tight Cocone (Meyer, "
      "Kirby, Whitaker 2007); the axis more finely sampled than the paper's, unless told otherwise";
  method.revision = 2;
  method.parameters = particles::pipeline_parameters(
      {"foot-points", "bounding", "iteration", "marching-cubes", "gauss-seidel", "tight-cocone"});
  method.mesh = particles::mesh_by_particles;
  return method;
}

}  // namespace isobench
