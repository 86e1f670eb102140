#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "isobench/datasets/preparation/prepare_steps.h"

namespace isobench {

namespace {

/// The weights at 0, 1, …, radius. The whole kernel, both sides, sums to 1.
template <class Real>
std::vector<Real> half_kernel(double sigma) {
  const int radius = static_cast<int>(std::lround(4.0 * sigma));
  if (radius == 0) return {Real{1}};  // here, too, if the square of sigma would be 0
  std::vector<double> weights(static_cast<std::size_t>(radius) + 1);
  double sum = 0.0;
  for (int t = 0; t <= radius; ++t) {
    weights[static_cast<std::size_t>(t)] = std::exp(-0.5 * t * t / (sigma * sigma));
    sum += (t == 0 ? 1.0 : 2.0) * weights[static_cast<std::size_t>(t)];
  }
  std::vector<Real> kernel;
  for (const double weight : weights) kernel.push_back(static_cast<Real>(weight / sum));
  return kernel;
}

/// Along x: copies each row, repeats its ends in the copy, and filters the copy into the row.
template <class Real>
void filter_x(RealVolume<Real>& volume, const std::vector<Real>& kernel) {
  const auto count = static_cast<std::size_t>(volume.lattice.size[0]);
  const std::size_t rows = volume.samples.size() / count;
  const std::size_t radius = kernel.size() - 1;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rows, 64), [&](const auto& range) {
    std::vector<Real> padded(count + 2 * radius);
    for (std::size_t row = range.begin(); row < range.end(); ++row) {
      Real* samples = volume.samples.data() + row * count;
      std::fill_n(padded.begin(), radius, samples[0]);
      std::copy_n(samples, count, padded.begin() + static_cast<std::ptrdiff_t>(radius));
      std::fill_n(padded.end() - static_cast<std::ptrdiff_t>(radius), radius, samples[count - 1]);
      const Real* centre = padded.data() + radius;
      for (std::size_t n = 0; n < count; ++n) samples[n] = kernel[0] * centre[n];
      for (std::size_t t = 1; t <= radius; ++t) {
        for (std::size_t n = 0; n < count; ++n) samples[n] += kernel[t] * (*(centre + n - t) + centre[n + t]);
      }
    }
  });
}

/// Along y or z: copies each sheet of `count` rows and filters the copy into the sheet, a whole row at a time.
template <class Real>
void filter_sheets(RealVolume<Real>& volume, int axis, const std::vector<Real>& kernel) {
  const auto nx = static_cast<std::size_t>(volume.lattice.size[0]);
  const auto ny = static_cast<std::size_t>(volume.lattice.size[1]);
  const auto nz = static_cast<std::size_t>(volume.lattice.size[2]);
  const std::size_t count = axis == 1 ? ny : nz;
  const std::size_t stride = axis == 1 ? nx : nx * ny;
  const std::size_t sheets = axis == 1 ? nz : ny;
  const std::size_t sheet_stride = axis == 1 ? nx * ny : nx;
  const std::size_t radius = kernel.size() - 1;
  tbb::parallel_for(std::size_t{0}, sheets, [&](std::size_t sheet) {
    Real* first = volume.samples.data() + sheet * sheet_stride;
    std::vector<Real> copy(count * nx);
    for (std::size_t n = 0; n < count; ++n) std::copy_n(first + n * stride, nx, copy.data() + n * nx);
    for (std::size_t n = 0; n < count; ++n) {
      Real* out = first + n * stride;
      const Real* centre = copy.data() + n * nx;
      for (std::size_t i = 0; i < nx; ++i) out[i] = kernel[0] * centre[i];
      for (std::size_t t = 1; t <= radius; ++t) {
        const Real* before = copy.data() + (n >= t ? n - t : 0) * nx;
        const Real* after = copy.data() + std::min(n + t, count - 1) * nx;
        for (std::size_t i = 0; i < nx; ++i) out[i] += kernel[t] * (before[i] + after[i]);
      }
    }
  });
}

}  // namespace

template <class Real>
void gaussian(RealVolume<Real>& volume, const Eigen::Vector3d& sigma, Monitor& monitor) {
  for (int axis = 0; axis < 3; ++axis) {
    monitor.progress(axis / 3.0);
    if (sigma[axis] <= 0.0) continue;
    const std::vector<Real> kernel = half_kernel<Real>(sigma[axis]);
    if (axis == 0)
      filter_x(volume, kernel);
    else
      filter_sheets(volume, axis, kernel);
  }
}

template void gaussian(FloatVolume&, const Eigen::Vector3d&, Monitor&);
template void gaussian(DoubleVolume&, const Eigen::Vector3d&, Monitor&);

}  // namespace isobench
