#include "isobench/methods/method.h"

#include "isobench/methods/particles/pipeline.h"

namespace isobench {

Method method_particles() {
  Method method;
  method.name = "particles";
  method.summary =
      "Particles on F = c relaxed to a hexagonal packing under the sizing field, closed by a sign-labelled Delaunay "
      "triangulation (after Meyer, Kirby, Whitaker 2007)";
  method.revision = 11;
  method.promises_manifold = true;
  method.microseconds_per_vertex = 70.0;
  method.bytes_per_vertex = 1300.0;
  method.parameters = particles::pipeline_parameters({.medial_axis = "shrinking-balls",
                                                      .sizing_nodes = "projected",
                                                      .limiter = "fast-iterative",
                                                      .seeds = "elimination",
                                                      .relaxation = "newton",
                                                      .surface = "labelled-delaunay",
                                                      .cure = 20.0,
                                                      .cure_relaxations = 16.0,
                                                      .gradation = 0.3,
                                                      .critical_floor = 0.02,
                                                      .finish = 3.0});
  method.mesh = particles::mesh_by_particles;
  return method;
}

}  // namespace isobench
