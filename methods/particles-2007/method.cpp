// The published pipeline, stage by stage. Its stages live with those of `particles`.
#include "methods/method.h"

#include "methods/particles/pipeline.h"

namespace isobench {

Method method_particles_2007() {
  Method method;
  method.name = "particles-2007";
  method.summary =
      "Particles as published: foot-point medial axis, explicit limiter, Gauss-Seidel relaxation, Tight Cocone (Meyer, "
      "Kirby, Whitaker 2007)";
  method.revision = 1;
  method.parameters = particles::pipeline_parameters(
      {"foot-points", "bounding", "iteration", "marching-cubes", "gauss-seidel", "tight-cocone"});
  method.mesh = particles::mesh_by_particles;
  return method;
}

}  // namespace isobench
