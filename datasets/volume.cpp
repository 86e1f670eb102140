#include "isobench/datasets/volume.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>
#include <type_traits>

#include "isobench/foundation/error.h"

namespace isobench {

double Lattice::voxel() const { return std::cbrt(spacing.prod()); }

Eigen::Vector3d Lattice::to_local(const Eigen::Vector3d& world) const { return direction.inverse() * (world - origin); }

bool Lattice::right_handed() const { return direction.determinant() > 0.0; }

namespace {

template <class T>
[[noreturn]] void throw_at_node(const Lattice& lattice, std::size_t n, T sample, const char* must) {
  const auto nx = static_cast<std::size_t>(lattice.size[0]);
  const auto ny = static_cast<std::size_t>(lattice.size[1]);
  throw DataError(
      fmt::format("the sample at node ({}, {}, {}) is {}; {}", n % nx, n / nx % ny, n / nx / ny, sample, must));
}

template <class T>
void check_finite_samples(const Lattice& lattice, const std::vector<T>& samples) {
  if constexpr (std::is_floating_point_v<T>) {
    for (std::size_t n = 0; n < samples.size(); ++n) {
      if (!std::isfinite(samples[n])) {
        throw_at_node(lattice, n, samples[n], "every sample must be a finite number, so replace it");
      }
    }
  }
}

/// The smallest and the largest sample.
template <class T>
std::pair<T, T> extremes(const Lattice& lattice, const std::vector<T>& samples) {
  if (samples.empty()) throw DataError("the volume has no samples; give one with samples");
  check_finite_samples(lattice, samples);
  std::pair<T, T> range{samples.front(), samples.front()};
  for (const T sample : samples) {
    if (sample < range.first) range.first = sample;
    if (sample > range.second) range.second = sample;
  }
  return range;
}

/// Rounding keeps the order, so the rounded extremes are the extremes of the rounded samples.
template <class T>
Range rounded_range(const Lattice& lattice, const std::vector<T>& samples) {
  const auto [least, most] = extremes(lattice, samples);
  return {static_cast<float>(least), static_cast<float>(most)};
}

}  // namespace

FloatVolume as_float(Volume volume) {
  volume.samples.visit([&](const auto& samples) {
    using T = SampleOf<decltype(samples)>;
    if constexpr (std::is_same_v<T, double>) {
      for (std::size_t n = 0; n < samples.size(); ++n) {
        if (std::isfinite(samples[n]) && !std::isfinite(static_cast<float>(samples[n]))) {
          throw_at_node(volume.lattice, n, samples[n], "it is too large for single precision; scale the volume down");
        }
      }
    }
  });
  return {std::move(volume.lattice), std::move(volume.samples).to_floats()};
}

Range sample_range(const Volume& volume) {
  return volume.samples.visit([&](const auto& samples) { return rounded_range(volume.lattice, samples); });
}

Range sample_range(const FloatVolume& volume) { return rounded_range(volume.lattice, volume.samples); }

std::string range_text(const Volume& volume) {
  return volume.samples.visit([&](const auto& samples) {
    const auto [least, most] = extremes(volume.lattice, samples);
    return fmt::format("[{}, {}]", least, most);
  });
}

void check_finite(const Volume& volume) {
  volume.samples.visit([&](const auto& samples) { check_finite_samples(volume.lattice, samples); });
}

}  // namespace isobench
