// Values that are no regular values of F: at such a value F = c touches itself, in points or along lines (the shared
// edge of two blocks of a mask), or fills space (a plateau). It is no surface then, and no mesh can have its topology.
#pragma once

#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/datasets/topology/certified_topology.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

/// The surface f = `value`, proven. For f = 0 of a regular value, `value` is 0.
struct RegularValue {
  double value = 0.0;
  CertifiedTopology topology;
  /// Of f = 0: where it is no surface. Empty if it is one, or if rounding hides the places.
  std::vector<CellBox> singular;
  /// Whether further critical values lie between 0 and `value`, so that topology differs elsewhere, too.
  bool passes_others = false;
};

/// Finds a value of f near 0 whose surface is one, by the least change that leaves room for triangles.
///
/// Tries −1e-4, −1e-3 and −1e-2 of the range of the spline's coefficients: down, because then F = c belongs to the
/// object (F ≥ c), and plateaus and touching blocks are kept. Takes the first for which no further critical value lies
/// between 0 and the value, and at which the narrowest place is wider than `narrowest` voxels: at a singular place with
/// the curvature λ (the largest magnitude of an eigenvalue of the Hessian) and a value that is s away, the place is
/// 2√(2s/|λ|) wide. If all are narrower, takes the largest without a further critical value; then tries the same
/// upwards; then values that pass further critical values. A surface that is empty or whose object reaches the border
/// is taken only if no other is found: so a plateau that reaches the border, such as a background of the value 0, is
/// left outside. Values up to a quarter of the smallest change count as 0 itself.
///
/// Throws DataError if there is no regular value among these; Cancelled. Cost: that of certified_topology() for a
/// regular value, else some five times that.
RegularValue find_regular_value(const Isosurface& surface, double narrowest, Monitor& monitor);

}  // namespace isobench
