// From samples to the coefficients of the cubic B-spline that passes through them.
#pragma once

#include "isobench/datasets/volume.h"

namespace isobench {

/// Solves, along each axis in turn, (c[n−1] + 4 c[n] + c[n+1])/6 = s[n] with c repeated beyond the border, as
/// Isosurface repeats it (Unser, Aldroubi, Eden 1991, there recursively with the pole √3 − 2). In place, linear time,
/// threaded.
void interpolating_coefficients(Volume& volume);

}  // namespace isobench
