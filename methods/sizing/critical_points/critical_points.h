// Critical points of F, where ∇F = 0, close to F = c. A small change of c can create or remove a handle, a bridge or a
// component only at such points (Morse theory). The features there are about as small as the point's distance to the
// surface, which may be far less than the lattice can resolve.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/methods/sizing/band.h"

namespace isobench {

struct CriticalPoint {
  Eigen::Vector3d position;  ///< lattice frame, mm
  double value = 0.0;        ///< f there, > 0 inside
  /// Distance to the surface, mm, from the quadratic part of f: √(2|f|/|μ|), where μ is the eigenvalue of the Hessian
  /// with the largest curvature towards f = 0.
  double distance = 0.0;
  int falling = 0;  ///< number of negative eigenvalues: 0 a minimum of f, 1 and 2 saddles, 3 a maximum
};

/// First, in the band's order, the critical points with a distance below `reach` (mm) in the cells whose lowest corner
/// is in the band. Then, at any distance, the maxima inside and the minima outside the object in hidden cells
/// (hidden_cells.h): each speck or cavity that no node shows has one.
///
/// Uses Newton's method from the middle of each cell; where its first step stays near the cell, also from the middles
/// of the cell's eighths. The result does not depend on the number of threads. Cost: about 1 µs of one core a band
/// node.
std::vector<CriticalPoint> critical_points(const Isosurface& surface, const Band& band, double reach);

}  // namespace isobench
