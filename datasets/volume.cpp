#include "isobench/datasets/volume.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "isobench/foundation/error.h"

namespace isobench {

double Lattice::voxel() const { return std::cbrt(spacing.prod()); }

Eigen::Vector3d Lattice::to_local(const Eigen::Vector3d& world) const { return direction.inverse() * (world - origin); }

bool Lattice::is_rectangular() const {
  return (direction.transpose() * direction - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 5e-3;
}

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

template <class T>
Range range_of(const Lattice& lattice, const std::vector<T>& samples) {
  const auto [least, most] = extremes(lattice, samples);
  return {static_cast<double>(least), static_cast<double>(most)};
}

}  // namespace

bool needs_double(const Volume& volume) {
  return volume.samples.visit([](const auto& samples) {
    using T = SampleOf<decltype(samples)>;
    if constexpr (std::is_same_v<RealOf<T>, float>) {
      return false;
    } else {
      return std::any_of(samples.begin(), samples.end(), [](T sample) {
        const auto exact = static_cast<double>(sample);
        const bool is_rounded =
            std::is_integral_v<T> && std::abs(exact) > 9007199254740992.0;  // 2^53: already in double
        return is_rounded || (static_cast<double>(static_cast<float>(sample)) != exact && !std::isnan(exact));
      });
    }
  });
}

template <class Real>
RealVolume<Real> as_real(Volume volume) {
  std::vector<Real> reals = volume.samples.visit([&](auto& samples) -> std::vector<Real> {
    using T = SampleOf<decltype(samples)>;
    if constexpr (std::is_same_v<T, Real>) {
      return std::move(samples);
    } else {
      if constexpr (std::is_same_v<T, double>) {
        for (std::size_t n = 0; n < samples.size(); ++n) {
          if (std::isfinite(samples[n]) && !std::isfinite(static_cast<Real>(samples[n])))
            throw_at_node(volume.lattice, n, samples[n], "it is too large for single precision; scale the volume down");
        }
      }
      return std::vector<Real>(samples.begin(), samples.end());
    }
  });
  return {std::move(volume.lattice), std::move(reals)};
}

template RealVolume<float> as_real(Volume volume);
template RealVolume<double> as_real(Volume volume);

Range sample_range(const Volume& volume) {
  return volume.samples.visit([&](const auto& samples) { return range_of(volume.lattice, samples); });
}

std::string range_text(const Volume& volume) {
  return volume.samples.visit([&](const auto& samples) {
    const auto [least, most] = extremes(volume.lattice, samples);
    return fmt::format("[{}, {}]", least, most);
  });
}

bool is_finite(const Volume& volume) {
  return volume.samples.visit([](const auto& samples) {
    if constexpr (std::is_floating_point_v<SampleOf<decltype(samples)>>)
      return std::all_of(samples.begin(), samples.end(), [](auto sample) { return std::isfinite(sample); });
    else
      return true;
  });
}

void check_finite(const Volume& volume) {
  volume.samples.visit([&](const auto& samples) { check_finite_samples(volume.lattice, samples); });
}

}  // namespace isobench
