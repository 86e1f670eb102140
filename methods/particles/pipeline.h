// Meshing by particles as a pipeline of stages; parameters choose an implementation for each stage. Two methods are
// presets of this pipeline and differ only in the defaults of their parameters: `particles`, our best, and
// `particles-2007`, the pipeline of Meyer, Kirby and Whitaker (2007).
#pragma once

#include <string>

#include "isobench/methods/method.h"

namespace isobench::particles {

/// Defaults of the parameters with the same names; pipeline_parameters.cpp explains each.
struct Preset {
  std::string medial_axis;        ///< "shrinking-balls" or "foot-points"
  std::string sizing_nodes;       ///< "projected" or "bounding"
  std::string limiter;            ///< "fast-iterative" or "iteration"
  std::string seeds;              ///< "elimination" or "marching-cubes"
  std::string relaxation;         ///< "newton" or "gauss-seidel", each with a population control of its own
  std::string surface;            ///< "labelled-delaunay" or "tight-cocone"
  double cure = 0.0;              ///< maximum number of rounds that only add particles
  double cure_relaxations = 0.0;  ///< maximum number of rounds that add particles and relax their surroundings
  double gradation = 100.0;       ///< upper bound on δ
  double critical_floor = 100.0;  ///< voxels: least h near critical points of F; no effect at or above the floor
  double finish = 0.0;            ///< rounds that improve valences and shapes
};

/// The parameters of the pipeline, with the preset's defaults.
ParameterSchema pipeline_parameters(const Preset& preset);

/// Stages of the monitor, in order: "sizing" (sizing_stage.h), "critical points" (only with an adaptive sizing),
/// "seeds", "relaxation", "triangulation" (with "cure" inside it, if there is a cure) and "finish" (if it has rounds).
///
/// Traces: "energy" after each sweep, "particles" after each population control, with `gauss-seidel` also "moves" after
/// each sweep, and "finish/places improved" after each local search of the finish. Artefacts: "particles" with "h" and
/// "energy"; with an adaptive sizing, also "floor-places" with "distance" and "falling"; and the sizing's artefacts.
/// Throws Error if the particles span no tetrahedron.
TriangleMesh mesh_by_particles(const MeshingTask& task, Monitor& monitor);

}  // namespace isobench::particles
