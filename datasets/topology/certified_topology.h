// The Euler characteristic and the components of F = c, proven from bounds on F instead of counted from samples.
//
// In a lattice cell F is a tricubic polynomial, and its Bernstein coefficients bound it and its derivatives. Cells are
// cut into eight until every box is decided: it is proven that f = F − c has no zero in it, or that
//   1. f rises strictly, or falls strictly, along one of the axes in the box;
//   2. on each of its six faces, f has no zero or does so along one of the face's two axes, and the same holds on each
//      of its twelve edges;
//   3. f is not zero at its corners.
// By 2 and 3, F = c crosses an edge once if its ends differ in sign, else not at all. The signs at the corners of a
// face cannot alternate, so F = c crosses a face in one arc if they differ, else not at all. By 1, the corners inside
// on one side of the axis are a part of those inside on the other side; so the inside corners are connected along
// edges, and so are the outside ones, and the arcs form at most one loop on the boundary of the box. By 1, F = c in the
// box is a graph over a part of a plane, and its boundary is that loop: it is one disc, or nothing. So the discs in the
// boxes, the arcs in the faces and the points on the edges form a cell complex of the surface. Where boxes of different
// depth meet, the faces and edges of the smaller ones count:
//
//     χ = points − arcs + discs.
//
// Sources: Snyder 1992 (Interval analysis for computer graphics); Plantinga, Vegter 2004 (Isotopic approximation of
// implicit curves and surfaces).
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "isobench/datasets/topology/subdivision.h"
#include "isobench/datasets/topology/surface_boxes.h"

namespace isobench {

/// One connected piece of F = c.
struct SurfaceComponent {
  long euler = 0;
  std::size_t boxes = 0;     ///< the number of boxes that it passes
  bool is_left_out = false;  ///< too small for what is asked for: meshes shall not have it (leave_out_below())
};

/// Within this share of the range of the spline's coefficients, values count as the same: the topology is proven for
/// each of them.
inline constexpr double same_value = 1e-9;

struct CertifiedTopology {
  /// If false, nothing was proven, and only `singular` is set: a critical value of F is c, or within same_value of it.
  bool is_regular = false;
  /// Small boxes, at most one for each lattice cell, in which f and ∇F are zero to within rounding.
  std::vector<CellBox> singular;

  long euler = 0;  ///< of all components that are not left out
  std::vector<SurfaceComponent> components;
  /// Whether F = c leaves the lattice. χ is then that of a surface with a boundary.
  bool is_open = false;
  /// Not 0 if F − c is zero at corners of boxes: the topology is then that of f = this value. No critical value of F
  /// lies between 0 and it. (On the lattice's border F is not looked at for critical values, which matters if is_open.)
  double counted_at = 0.0;
  std::shared_ptr<const SurfaceBoxes> boxes;  ///< where the components are

  std::size_t kept_components() const;  ///< those that are not left out
};

/// The topology of f = `value`; `cut_at`: see usual_cut. Throws Cancelled. Threads: all; the result does not depend on
/// their number. Cost: 1 to 2 µs of one core for each cell that F = c may cross, and up to 4 µs for binary masks.
CertifiedTopology certified_topology(const Isosurface& surface, Monitor& monitor, double cut_at = usual_cut,
                                     double value = 0.0);

/// The range of the spline's coefficients: the largest less the smallest.
double coefficient_range(const Isosurface& surface);

/// Differences of coefficients up to this count as zero: 64 coefficients and few operations a cut, in double precision.
inline double rounding_of(double coefficient_range) { return 1e-13 * coefficient_range; }

}  // namespace isobench
