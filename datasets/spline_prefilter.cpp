#include "isobench/datasets/spline_prefilter.h"

#include <tbb/parallel_for.h>

#include <vector>

namespace isobench {

namespace {

/// Solves (c[n−1] + 4 c[n] + c[n+1])/6 = s[n] for `width` neighbouring lines at once; c is repeated beyond both ends.
/// The matrix is diagonally dominant, so elimination needs no pivoting.
void solve_lines(float* first, std::size_t count, std::size_t stride, std::size_t width, std::vector<double>& work) {
  work.resize(count * width + count);
  double* upper = work.data() + count * width;  // the eliminated matrix's upper diagonal
  for (std::size_t n = 0; n < count; ++n) {
    const bool edge = n == 0 || n + 1 == count;
    const double diagonal = (edge ? 5.0 : 4.0) - (n > 0 ? upper[n - 1] : 0.0);
    upper[n] = 1.0 / diagonal;
    const float* samples = first + n * stride;
    double* row = work.data() + n * width;
    for (std::size_t i = 0; i < width; ++i) {
      const double before = n > 0 ? *(row + i - width) : 0.0;
      row[i] = (6.0 * static_cast<double>(samples[i]) - before) * upper[n];
    }
  }
  for (std::size_t n = count; n-- > 0;) {
    float* samples = first + n * stride;
    double* row = work.data() + n * width;
    for (std::size_t i = 0; i < width; ++i) {
      if (n + 1 < count) row[i] -= upper[n] * row[i + width];
      samples[i] = static_cast<float>(row[i]);
    }
  }
}

}  // namespace

void interpolating_coefficients(FloatVolume& volume) {
  const auto nx = static_cast<std::size_t>(volume.lattice.size[0]);
  const auto ny = static_cast<std::size_t>(volume.lattice.size[1]);
  const auto nz = static_cast<std::size_t>(volume.lattice.size[2]);
  const auto along = [&](std::size_t sheets, std::size_t sheet_stride, std::size_t count, std::size_t stride,
                         std::size_t width) {
    if (count < 2) return;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, sheets), [&](const auto& range) {
      std::vector<double> work;
      for (std::size_t sheet = range.begin(); sheet < range.end(); ++sheet) {
        solve_lines(volume.samples.data() + sheet * sheet_stride, count, stride, width, work);
      }
    });
  };
  along(ny * nz, nx, nx, 1, 1);
  along(nz, nx * ny, ny, nx, nx);
  along(ny, nx, nz, nx * ny, nx);
}

}  // namespace isobench
