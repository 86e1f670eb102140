// F − c in one lattice cell as a tricubic polynomial in the Bernstein basis. The 64 coefficients bound the polynomial
// on its box, and the differences of neighbouring coefficients bound its derivatives (convex hull property: Farouki
// 2012, The Bernstein polynomial basis: a centennial retrospective).
#pragma once

#include <array>
#include <cstddef>

#include "isobench/datasets/isosurface.h"

namespace isobench {

/// A tricubic polynomial on a box. The coefficient with index (i, j, k), each 0 to 3, is at i + 4j + 16k. The eight
/// corner coefficients are the values at the corners; those of a face or an edge are the polynomial there.
struct Tricubic {
  alignas(32) std::array<double, 64> b;

  /// The value at corner x + 2y + 4z, each 0 or 1.
  double corner(unsigned number) const { return b[3 * (number & 1U) + 12 * (number >> 1 & 1U) + 48 * (number >> 2)]; }
};

/// f + `offset` in the lattice cell between node (i, j, k) and node (i + 1, j + 1, k + 1), for the kernel of the
/// surface.
Tricubic cell_polynomial(const Isosurface& surface, int i, int j, int k, double offset);

/// Where a box is cut along every axis, from 0 to 1. Not ½: F of a binary mask equals 0.5 on planes half-way between
/// nodes, and boxes with faces on such planes would be cut for ever.
inline constexpr double usual_cut = 0.4786;

/// The polynomial on the eight parts of its box (de Casteljau). Part x + 2y + 4z is on the high side of the axes whose
/// bit is 1.
void cut(const Tricubic& whole, double at, std::array<Tricubic, 8>& parts);

}  // namespace isobench
