// From samples to the coefficients of the cubic B-spline that passes through them.
#pragma once

#include "isobench/datasets/volume.h"

namespace isobench {

/// Replaces the samples by coefficients. Solves (c[n−1] + 4 c[n] + c[n+1])/6 = s[n] along one axis after the other;
/// beyond the border c is repeated, as Isosurface does. Unser, Aldroubi and Eden (1991) solve the same system
/// recursively with the pole √3 − 2. Linear time, threaded.
void interpolating_coefficients(FloatVolume& volume);

}  // namespace isobench
