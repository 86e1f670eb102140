// The steps that sample a volume anew, on a lattice of another spacing.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "isobench/datasets/preparation/prepare_steps.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

/// Where the nodes of one resampled axis lie between the old ones.
struct Taps {
  std::vector<int> lower;      // the old node at or below the new one
  std::vector<double> weight;  // of the old node after it
  double spacing = 1.0;        // mm, between new nodes
};

Taps taps_of(int count, double from, double to, int axis) {
  if (!(to > 0.0))
    throw DataError(fmt::format("resample: the spacing of axis {} is not > 0 mm; give one that is", axis));
  const double length = from * (count - 1);
  if (!(length / to < 1e6))
    throw DataError(fmt::format(
        "resample: a spacing of {} mm gives axis {} more than a million nodes; take a larger one", to, axis));
  const int fresh = count == 1 ? 1 : std::max(2, static_cast<int>(std::lround(length / to)) + 1);
  Taps taps;
  taps.spacing = fresh == 1 ? from : length / (fresh - 1);
  for (int n = 0; n < fresh; ++n) {
    // Integers as far as possible, so that a new node at the place of an old one lies there exactly.
    const long long numerator = static_cast<long long>(n) * (count - 1);
    const long long denominator = std::max(fresh - 1, 1);
    const int lower = static_cast<int>(std::min<long long>(numerator / denominator, std::max(count - 2, 0)));
    taps.lower.push_back(lower);
    taps.weight.push_back(static_cast<double>(numerator - lower * denominator) / static_cast<double>(denominator));
  }
  return taps;
}

template <class Real>
RealVolume<Real> with_size(const Lattice& lattice, const std::array<int, 3>& size) {
  check_size(size);
  RealVolume<Real> result{lattice, {}};
  result.lattice.size = size;
  result.samples.resize(result.lattice.nodes());
  return result;
}

template <class Real>
RealVolume<Real> interpolated(const RealVolume<Real>& volume, const Eigen::Vector3d& spacing) {
  Taps taps[3];
  std::array<int, 3> size{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int a = static_cast<int>(axis);
    taps[axis] = taps_of(volume.lattice.size[axis], volume.lattice.spacing[a], spacing[a], a);
    size[axis] = static_cast<int>(taps[axis].lower.size());
  }
  RealVolume<Real> result = with_size<Real>(volume.lattice, size);
  for (int axis = 0; axis < 3; ++axis) result.lattice.spacing[axis] = taps[axis].spacing;
  const auto above = [&](int n, std::size_t axis) { return std::min(n + 1, volume.lattice.size[axis] - 1); };
  tbb::parallel_for(0, size[2], [&](int k) {
    const int z = taps[2].lower[static_cast<std::size_t>(k)];
    const auto wz = static_cast<Real>(taps[2].weight[static_cast<std::size_t>(k)]);
    for (int j = 0; j < size[1]; ++j) {
      const int y = taps[1].lower[static_cast<std::size_t>(j)];
      const auto wy = static_cast<Real>(taps[1].weight[static_cast<std::size_t>(j)]);
      const Real* rows[] = {&volume.samples[volume.lattice.index(0, y, z)],
                            &volume.samples[volume.lattice.index(0, above(y, 1), z)],
                            &volume.samples[volume.lattice.index(0, y, above(z, 2))],
                            &volume.samples[volume.lattice.index(0, above(y, 1), above(z, 2))]};
      Real* out = &result.samples[result.lattice.index(0, j, k)];
      for (int i = 0; i < size[0]; ++i) {
        const int x = taps[0].lower[static_cast<std::size_t>(i)];
        const int x1 = above(x, 0);
        const auto wx = static_cast<Real>(taps[0].weight[static_cast<std::size_t>(i)]);
        const auto along = [&](const Real* row) { return (Real{1} - wx) * row[x] + wx * row[x1]; };
        const Real lower = (Real{1} - wy) * along(rows[0]) + wy * along(rows[1]);
        const Real upper = (Real{1} - wy) * along(rows[2]) + wy * along(rows[3]);
        out[i] = (Real{1} - wz) * lower + wz * upper;
      }
    }
  });
  return result;
}

}  // namespace

template <class Real>
RealVolume<Real> resample(const RealVolume<Real>& volume, const Eigen::Vector3d& spacing) {
  return interpolated(volume, spacing);
}

template <class Real>
RealVolume<Real> subsample(const RealVolume<Real>& volume, int factor) {
  if (factor < 1) throw DataError("subsample: the factor is below 1; give one of at least 1");
  std::array<int, 3> size{};
  for (std::size_t axis = 0; axis < 3; ++axis) size[axis] = volume.lattice.size[axis] / factor;
  if (*std::min_element(size.begin(), size.end()) < 1) {
    throw DataError(
        fmt::format("subsample: a factor of {} leaves no node of a volume of {} × {} × {}; take a smaller one", factor,
                    volume.lattice.size[0], volume.lattice.size[1], volume.lattice.size[2]));
  }
  RealVolume<Real> result = with_size<Real>(volume.lattice, size);
  const double scale = 1.0 / (static_cast<double>(factor) * factor * factor);
  tbb::parallel_for(0, size[2], [&](int k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        double sum = 0.0;
        for (int z = 0; z < factor; ++z) {
          for (int y = 0; y < factor; ++y) {
            for (int x = 0; x < factor; ++x) sum += volume.at(i * factor + x, j * factor + y, k * factor + z);
          }
        }
        result.at(i, j, k) = static_cast<Real>(scale * sum);
      }
    }
  });
  result.lattice.origin = volume.lattice.to_world(0.5 * (factor - 1) * volume.lattice.spacing);
  result.lattice.spacing *= factor;
  return result;
}

template FloatVolume resample(const FloatVolume&, const Eigen::Vector3d&);
template DoubleVolume resample(const DoubleVolume&, const Eigen::Vector3d&);
template FloatVolume subsample(const FloatVolume&, int);
template DoubleVolume subsample(const DoubleVolume&, int);

}  // namespace isobench
