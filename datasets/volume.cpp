#include "isobench/datasets/volume.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>

#include "isobench/foundation/error.h"

namespace isobench {

double Lattice::voxel() const { return std::cbrt(spacing.prod()); }

Eigen::Vector3d Lattice::to_local(const Eigen::Vector3d& world) const { return direction.inverse() * (world - origin); }

bool Lattice::right_handed() const { return direction.determinant() > 0.0; }

Range sample_range(const Volume& volume) {
  if (volume.samples.empty()) throw DataError("the volume has no samples");
  Range range{volume.samples.front(), volume.samples.front()};
  for (std::size_t n = 0; n < volume.samples.size(); ++n) {
    const float sample = volume.samples[n];
    if (!std::isfinite(sample)) {
      const auto nx = static_cast<std::size_t>(volume.lattice.size[0]);
      const auto ny = static_cast<std::size_t>(volume.lattice.size[1]);
      throw DataError(fmt::format("the sample at node ({}, {}, {}) is {}; every sample must be a finite number", n % nx,
                                  n / nx % ny, n / nx / ny, sample));
    }
    if (sample < range.min) range.min = sample;
    if (sample > range.max) range.max = sample;
  }
  return range;
}

}  // namespace isobench
