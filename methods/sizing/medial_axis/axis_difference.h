// Where the feature sizes of two medial axes differ: foot points (as published) and shrinking balls (the reference).
#pragma once

#include <array>
#include <vector>

#include "isobench/methods/sizing/medial_axis/shrinking_balls.h"

namespace isobench {

/// What a sample of the surface lies at, as far as the two axes can differ there.
enum class AxisPlace {
  thin,    ///< λ below two voxels: foot points, about a voxel apart, are too sparse for it
  missed,  ///< λ larger, and no foot point within a voxel of the centre of the nearest ball: the axis was not found
           ///< there. Its ends are so, where the angle closes; that the place is one is not checked. As λ cannot be
           ///< overestimated by more than a voxel elsewhere, every larger overestimate is here or at a thin part.
  other,
};

struct AxisDifference {
  std::vector<double> by_feet;   ///< min(λ, 1/|κ|) a sample, mm, λ to the nearest foot point
  std::vector<double> by_balls;  ///< the same with λ to the nearest centre of a ball
  std::vector<AxisPlace> place;  ///< of each sample
  double median = 0.0;           ///< of |by_feet / by_balls − 1|
  double p95 = 0.0;              ///< of |by_feet − by_balls|, voxels
  /// Percent of all samples at each place, and of those that differ by more than a voxel; 0 where none does.
  std::array<double, 3> share{};
  std::array<double, 3> share_of_differing{};
  double differing = 0.0;  ///< percent of all samples that differ by more than a voxel
};

/// Neither axis may be larger than `cap` (mm) says. Precondition: samples are not empty. Cost: three nearest-neighbour
/// queries a sample, one thread.
AxisDifference axis_difference(const SurfaceSamples& samples, const MedialBalls& feet, const MedialBalls& balls,
                               double voxel, double cap);

}  // namespace isobench
