// The cure adds particles where there are too few, so that the triangulation gets the topology of the surface.
// The restricted Delaunay triangulation has the surface's topology once the balls of all its facets are small against
// the feature size (Boissonnat, Oudot 2005), so adding particles helps in the end.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "isobench/datasets/topology/certified_topology.h"
#include "isobench/methods/closing/labelled_delaunay.h"
#include "isobench/methods/particles/relaxation/population_control.h"

namespace isobench::particles {

/// The numbers of defects of a triangulation.
struct Defects {
  std::size_t pinched = 0;    ///< points whose triangles do not form one closed fan
  std::size_t isolated = 0;   ///< points without a triangle
  std::size_t tilted = 0;     ///< triangles at more than 60° to the normal at one of their corners
  std::size_t crossed = 0;    ///< triangles whose dual edge crosses the surface more than once
  std::size_t lost = 0;       ///< components of F = c on which no point has a triangle
  std::size_t differing = 0;  ///< components of F = c shown otherwise than they are (component_match.h); in the end

  std::size_t all() const { return pinched + isolated + tilted + crossed + lost + differing; }
};

struct CureOptions {
  int relaxations = 0;               ///< maximum number of rounds that add particles and relax their surroundings
  int rounds = 20;                   ///< maximum number of rounds after them that only add particles
  double least_h = 0.0;              ///< mm: the relaxations do not make h smaller than this
  PopulationLimits population = {};  ///< population control of the relaxations
  /// The number of particles that the sizing asks for, if another cure may have added to them; 0: those that are there.
  std::size_t usual_particles = 0;
};

struct CureResult {
  Defects before;
  Defects after;
  std::vector<Eigen::Vector3d> differs_near;  ///< a place on each component that differs in the end
  std::size_t inserted = 0;                   ///< particles added because of defects
  std::size_t relaxed = 0;                    ///< particles that relaxations exchanged, summed over all relaxations
  std::size_t flipped = 0;                    ///< cells whose label was changed as a last resort
  int rounds = 0;                             ///< rounds done without relaxation
  int relaxations = 0;                        ///< relaxations done
  bool gave_up = false;                       ///< more particles would only make more defects
};

/// Adds particles where the triangulation differs from the surface: where the dual edges of defective facets cross
/// F = c, around points without a facet, and on components of F = c without a facet. `topology` is
/// that of the surface; `particles` and `delaunay` hold the same points before and after.
///
/// The relaxations come first. Each adds particles, makes h smaller there and at defects where no particle has room,
/// and relaxes the surroundings (local_relaxation.h); about half of the defects remain after each, once there are
/// enough particles to show the surface at all. If defects remain after the last relaxation, rounds that only add
/// particles follow; these may be ever closer to others if too few have room. Pinches that still remain are cut by
/// changing the label of a cell.
///
/// At the end, the triangulation is compared with F = c component by component. If one differs, it gets particles at
/// its smallest places (the deepest boxes of the proof), and the cure begins again, at most three times.
///
/// The cure gives up once there are several particles for each box of the proof, or far more defects than before
/// whose number per particle does not fall. With Kernel::catmull_rom, whose derivatives are not those of its values,
/// it gives up sooner, does half of the relaxations, and keeps new particles apart.
///
/// The result does not depend on the number of threads. Cost: 1 µs a facet on all threads, and about 80 µs on one
/// thread for each relaxed particle.
CureResult cure(SizedSurface& sized, const CertifiedTopology& topology, Particles& particles,
                LabelledDelaunay& delaunay, const CureOptions& options, Monitor& monitor);

}  // namespace isobench::particles
