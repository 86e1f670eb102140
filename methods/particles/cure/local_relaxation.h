// Relaxing a few particles again, where the sizing turned out too large.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "isobench/methods/particles/sampling/relaxation.h"
#include "isobench/methods/particles/sampling/size_bounds.h"

namespace isobench::particles {

/// Makes h smaller around the points, by 0.7 within 1.2 times the spacing, and rising again from there, but nowhere
/// smaller than `least` mm. `smaller`, which gets the places, is where `spacing` looks for them.
void shrink_around(const std::vector<Eigen::Vector3d>& points, const Spacing& spacing, SizeBounds& smaller,
                   double least = 0.0);

struct Exchange {
  std::vector<std::uint32_t> gone;  ///< ascending
  Particles fresh;                  ///< what stands for them
};

/// Makes h smaller around the points (shrink_around), and relaxes the particles within twice the spacing, with
/// population control, among the others, which stay. Time linear in the particles, but with a small factor: what counts
/// are those that move.
Exchange relax_around(const std::vector<Eigen::Vector3d>& points, const Isosurface& surface, const Spacing& spacing,
                      SizeBounds& smaller, double least, const Particles& particles, Monitor& monitor);

}  // namespace isobench::particles
