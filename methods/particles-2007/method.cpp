// The published pipeline, stage by stage; the code of the stages is in methods/particles. One default differs from the
// paper: the medial axis is searched from nodes finer than the lattice near the surface, and its ends are included,
// because the paper itself says that the sampling can be no better than the axis. With axis_ends = "left-out" and
// axis_halvings = 0 the pipeline is as published.
#include "isobench/methods/method.h"

#include "isobench/methods/particles/pipeline.h"

namespace isobench {

Method method_particles_2007() {
  Method method;
  method.name = "particles-2007";
  method.summary =
      "Particles as published: foot-point medial axis, explicit limiter, Gauss-Seidel relaxation, Tight Cocone (Meyer, "
      "Kirby, Whitaker 2007); by default the axis is sampled more finely than in the paper";
  method.revision = 2;
  method.parameters = particles::pipeline_parameters(
      {"foot-points", "bounding", "iteration", "marching-cubes", "gauss-seidel", "tight-cocone"});
  method.mesh = particles::mesh_by_particles;
  return method;
}

}  // namespace isobench
