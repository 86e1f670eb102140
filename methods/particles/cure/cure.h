// Topology by sampling: where the labelled Delaunay triangulation of the particles is not the surface's, the particles
// are too few, and more are added just there (after Boissonnat, Oudot 2005: the restricted Delaunay triangulation has
// the surface's topology once every ball of its facets is small against the feature size).
#pragma once

#include <cstddef>
#include <vector>

#include "isobench/methods/closing/labelled_delaunay.h"
#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/methods/particles/sampling/relaxation.h"

namespace isobench::particles {

/// What is wrong with a triangulation, counted.
struct Defects {
  std::size_t pinched = 0;   ///< points whose triangles do not form one closed fan
  std::size_t isolated = 0;  ///< points without a triangle
  std::size_t tilted = 0;    ///< triangles turned more than 60° from the normal at one of their corners
  std::size_t crossed = 0;   ///< triangles whose dual edge crosses the surface more than once
  std::size_t lost = 0;      ///< components of the lattice mesh without a triangle

  std::size_t all() const { return pinched + isolated + tilted + crossed + lost; }
};

struct Cure {
  Defects before;
  Defects after;
  std::size_t inserted = 0;
  std::size_t relaxed = 0;  ///< particles, in all, that were relaxed again
  std::size_t flipped = 0;  ///< cells whose label was changed as a last resort
  int rounds = 0;           ///< without a relaxation
  int relaxations = 0;
};

struct CureLimits {
  int rounds = 20;      ///< of adding particles only
  int relaxations = 0;  ///< before that: of adding particles and relaxing their surroundings
  double least = 0.0;   ///< mm: what h is not made smaller than
};

/// Adds particles where the triangulation is not the surface's: at the points in which the dual edges of the facets
/// concerned cross F = c, around points without a facet, and on components of `lattice_mesh` that have none. There, and
/// where something is wrong but none more fits, h is made smaller and the surroundings relax (relax_around); each
/// relaxation leaves about half of what was wrong. Where it leaves anything in the end, or is not asked for, particles
/// are added again and again. What pinches still remain are cut by changing the label of a cell. Particles and
/// triangulation stay in step. `smaller` is where `spacing` looks for smaller places; without it nothing is relaxed.
/// Deterministic for any number of threads. Cost: 1 µs a facet, on all threads, and some 80 µs, on one, for each
/// particle that is relaxed.
Cure cure(const Isosurface& surface, const Spacing& spacing, SizeBounds* smaller, const TriangleMesh& lattice_mesh,
          Particles& particles, LabelledDelaunay& delaunay, const CureLimits& limits, Monitor& monitor);

}  // namespace isobench::particles
