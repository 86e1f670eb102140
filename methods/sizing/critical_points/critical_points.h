// Where ∇F = 0 close to F = c: there, and only there, a small change of c makes or breaks a handle, a bridge or a
// component (Morse theory), and features are as small as the distance to the surface tells. A lattice of nodes one
// voxel apart cannot show sizes that fall below a voxel within a voxel; these points can.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/methods/sizing/band.h"

namespace isobench {

struct CriticalPoint {
  Eigen::Vector3d position;  ///< lattice frame, mm
  double value = 0.0;        ///< f there, > 0 inside
  /// mm to the surface, as f's quadratic part has it: √(2|f|/|μ|), μ the eigenvalue of the Hessian that bends f most
  /// towards 0.
  double distance = 0.0;
  int falling = 0;  ///< negative eigenvalues: 0 a minimum of f, 1 and 2 saddles, 3 a maximum
};

/// Those whose distance is below `reach` (mm), in the cells whose lowest corner is in the band, in the band's order;
/// and after them, at any distance and wherever they are, the peaks above and the pits below F = c of hidden cells
/// (hidden_cells.h): a speck or cavity that no node shows has one, as has the tip of what reaches into such a cell.
/// Newton's method from the middle of each cell, and from those of its eighths where the first step stays near.
/// Multi-threaded; the result does not depend on the number of threads. Cost: about 1 µs of one core a band node.
std::vector<CriticalPoint> critical_points(const Isosurface& surface, const Band& band, double reach);

}  // namespace isobench
