// Meshing by particles, from stages chosen by name. Two methods are presets of it: `particles`, our best, and
// `particles-2007`, the pipeline of Meyer, Kirby and Whitaker (2007); every difference between them is one parameter.
#pragma once

#include <string>

#include "isobench/methods/method.h"

namespace isobench::particles {

/// Names of stages, as the parameters of the same names take them.
struct Preset {
  std::string medial_axis;        ///< "shrinking-balls", "foot-points"
  std::string sizing_nodes;       ///< "projected", "bounding"
  std::string limiter;            ///< "fast-iterative", "iteration"
  std::string seeds;              ///< "elimination", "marching-cubes"
  std::string relaxation;         ///< "newton", "gauss-seidel", each with its own control of the population
  std::string surface;            ///< "labelled-delaunay", "tight-cocone"
  double cure = 0.0;              ///< rounds, at most, in which particles are added to cure the triangulation
  double cure_relaxations = 0.0;  ///< of the surroundings of those particles, at most
  double gradation = 100.0;       ///< largest δ that is meshed by
  double critical_floor = 100.0;  ///< voxels: h goes down to this near critical points of F; the floor's or more: not
  double finish = 0.0;            ///< rounds in which valences and shapes of the mesh are made good
};

/// The parameters of a method with these stages as its defaults.
ParameterSchema pipeline_parameters(const Preset& preset);

/// Stages "sizing", "seeds", "relaxation", "triangulation", "finish" of the monitor. Traces "energy" and "moves" once a
/// sweep, "particles" once a round; artefact "particles", with "h" and "energy". Throws Skipped where no particle is
/// left.
TriangleMesh mesh_by_particles(const MeshingTask& task, Monitor& monitor);

}  // namespace isobench::particles
