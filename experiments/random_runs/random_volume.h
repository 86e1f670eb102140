// For tests: small volumes at random, with the features of real ones that are hard on meshing: plateaus, samples that
// equal the isovalue, parts that touch, parts of a single voxel, thick slices.
#pragma once

#include <cstdint>
#include <string>

#include "isobench/datasets/volume.h"
#include "isobench/foundation/random.h"

namespace isobench {

/// A sequence of random numbers.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : seed_(seed) {}

  /// Uniform in [0, 1).
  double next() { return uniform_random(seed_, ++drawn_, 0); }
  double between(double low, double high) { return low + (high - low) * next(); }
  /// 0 to count − 1.
  int below(int count) { return static_cast<int>(next() * count); }
  bool chance(double share) { return next() < share; }

 private:
  std::uint64_t seed_;
  std::uint64_t drawn_ = 0;
};

struct RandomVolume {
  std::string kind;
  Volume volume;
  double isovalue = 0.0;  ///< often a value that many samples have, or one between two plateaus
};

/// 8 to 17 nodes along each axis, spacing 1 mm to 7 mm, in any sample type that holds the values.
RandomVolume random_volume(RandomNumbers& random);

}  // namespace isobench
