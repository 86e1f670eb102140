// The Euler characteristic and the components of F = c, proven from bounds on F instead of counted from samples.
//
// In a lattice cell F is a tricubic polynomial, and its Bernstein coefficients bound it and its derivatives. Cells are
// cut into eight until it is proven of every box that
//   1. F on the box has no zero of f = F − c, or rises strictly in a fixed direction;
//   2. so does F on each of its six faces, in a direction within the face, and on each of its twelve edges;
//   3. f is not zero at its corners;
//   4. no face has its inside corners on a diagonal, and the inside corners are one piece along the box's edges, as are
//      the outside ones.
// By 2 and 3, F = c crosses an edge exactly if its ends differ in sign, and a face in arcs that join such edges; by 4
// these arcs are one loop on the boundary of the box. By 1, F = c in the box is a graph over a plane whose boundary is
// that loop: one disc. So the discs, the arcs in the faces and the points on the edges of the subdivision are a cell
// complex of the surface, with each face and edge taken as small as boxes of different depth divide it:
//
//     χ = points − arcs + discs.
//
// Sources: Snyder 1992 (Interval analysis for computer graphics); Plantinga, Vegter 2004 (Isotopic approximation of
// implicit curves and surfaces).
#pragma once

#include <cstddef>
#include <vector>

#include "isobench/datasets/topology/subdivision.h"

namespace isobench {

/// One connected piece of F = c.
struct SurfaceComponent {
  long euler = 0;
  std::size_t boxes = 0;  ///< in how many boxes it is
};

struct CertifiedTopology {
  /// If false, c is no regular value: there are points where f = 0 and ∇F = 0 to within rounding, in the boxes of
  /// `singular`, and nothing else is set.
  bool is_regular = false;
  std::vector<Box> singular;  ///< at most one per lattice cell

  long euler = 0;
  std::vector<SurfaceComponent> components;
  /// Whether F = c leaves the lattice; χ is then that of a surface with a boundary.
  bool is_open = false;
  /// The topology was counted at f = this value, because F − c is zero at corners of the lattice or along its faces.
  /// There is no critical value between 0 and this value.
  double counted_at = 0.0;
  std::size_t boxes = 0;  ///< with a disc
  int deepest = 0;        ///< number of cuts of the smallest box
};

/// Threads: all. The result does not depend on their number.
CertifiedTopology certified_topology(const Isosurface& surface, Monitor& monitor, const CutRule& rule = {});

}  // namespace isobench
