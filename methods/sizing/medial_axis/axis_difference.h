// How far the feature sizes of two medial axes differ: foot points (as published) and shrinking balls (the reference).
#pragma once

#include <array>
#include <vector>

#include "isobench/methods/sizing/medial_axis/shrinking_balls.h"

namespace isobench {

/// Why the two axes can differ at a sample of the surface.
enum class AxisPlace {
  thin,    ///< λ is below two voxels; foot points, about a voxel apart, are too sparse for that
  missed,  ///< λ is larger, but no foot point is within a voxel of the centre of the nearest ball: the axis was not
           ///< found there, as happens at its ends. Foot points overestimate λ by more than a voxel only here and at
           ///< thin parts.
  other,   ///< neither
};

struct AxisDifference {
  std::vector<double> by_feet;   ///< min(λ, 1/|κ|) of each sample, mm, with λ to the nearest foot point
  std::vector<double> by_balls;  ///< the same with λ to the nearest centre of a ball
  std::vector<AxisPlace> place;  ///< for each sample
  double median = 0.0;           ///< median of |by_feet / by_balls − 1|
  double p95 = 0.0;              ///< 95th percentile of |by_feet − by_balls|, voxels
  /// Percentage of each place among all samples, and among the samples that differ by more than a voxel (0 if there
  /// are none).
  std::array<double, 3> share{};
  std::array<double, 3> share_of_differing{};
  double differing = 0.0;  ///< percentage of samples that differ by more than a voxel
};

/// `cap` (mm) is the upper bound on λ. Precondition: there are samples. Cost: three nearest-neighbour queries per
/// sample on one thread.
AxisDifference axis_difference(const SurfaceSamples& samples, const MedialBalls& feet, const MedialBalls& balls,
                               double voxel, double cap);

}  // namespace isobench
