#include "isobench/datasets/topology/tricubic.h"

namespace isobench {

namespace {

/// Bernstein coefficients from four neighbouring spline coefficients.
using Conversion = std::array<double, 4> (*)(double, double, double, double);

std::array<double, 4> from_bspline(double a, double b, double c, double d) {
  return {(a + 4.0 * b + c) / 6.0, (2.0 * b + c) / 3.0, (b + 2.0 * c) / 3.0, (b + 4.0 * c + d) / 6.0};
}

std::array<double, 4> from_catmull_rom(double a, double b, double c, double d) {
  return {b, b + (c - a) / 6.0, c - (d - b) / 6.0, c};
}

/// Converts the four values of each line along one axis; `step` is the distance between neighbours of a line.
void convert(std::array<double, 64>& b, std::size_t step, Conversion conversion) {
  for (std::size_t n = 0; n < 64; ++n) {
    if (n / step % 4 != 0) continue;
    const std::array<double, 4> line = conversion(b[n], b[n + step], b[n + 2 * step], b[n + 3 * step]);
    for (std::size_t m = 0; m < 4; ++m) b[n + m * step] = line[m];
  }
}

/// Cuts `count` lines at once. Neighbours of a line are `count` apart.
template <std::size_t count>
void cut_lines(const double* b, double at, double* low, double* high) {
  const double rest = 1.0 - at;
  for (std::size_t n = 0; n < count; ++n) {
    const double b0 = b[n];
    const double b1 = b[n + count];
    const double b2 = b[n + 2 * count];
    const double b3 = b[n + 3 * count];
    const double b01 = rest * b0 + at * b1;
    const double b12 = rest * b1 + at * b2;
    const double b23 = rest * b2 + at * b3;
    const double b012 = rest * b01 + at * b12;
    const double b123 = rest * b12 + at * b23;
    const double middle = rest * b012 + at * b123;
    low[n] = b0;
    low[n + count] = b01;
    low[n + 2 * count] = b012;
    low[n + 3 * count] = middle;
    high[n] = middle;
    high[n + count] = b123;
    high[n + 2 * count] = b23;
    high[n + 3 * count] = b3;
  }
}

}  // namespace

Tricubic cell_polynomial(const Isosurface& surface, int i, int j, int k, double offset) {
  Tricubic cell;
  std::size_t n = 0;
  for (int w = k - 1; w < k + 3; ++w) {
    for (int v = j - 1; v < j + 3; ++v) {
      for (int u = i - 1; u < i + 3; ++u) cell.b[n++] = static_cast<double>(surface.coefficient(u, v, w)) + offset;
    }
  }
  const Conversion conversion = surface.kernel() == Kernel::catmull_rom ? from_catmull_rom : from_bspline;
  for (const std::size_t step : {1U, 4U, 16U}) convert(cell.b, step, conversion);
  return cell;
}

void cut(const Tricubic& whole, double at, std::array<Tricubic, 8>& parts) {
  // Along z first, because the lines of an axis that are neighbours in memory are cut together.
  cut_lines<16>(whole.b.data(), at, parts[0].b.data(), parts[4].b.data());
  for (const std::size_t z : {0U, 4U}) {
    Tricubic slab = parts[z];
    for (std::size_t n = 0; n < 64; n += 16) cut_lines<4>(&slab.b[n], at, &parts[z].b[n], &parts[z + 2].b[n]);
    for (const std::size_t y : {0U, 2U}) {
      const Tricubic row = parts[z + y];
      for (std::size_t n = 0; n < 64; n += 4) cut_lines<1>(&row.b[n], at, &parts[z + y].b[n], &parts[z + y + 1].b[n]);
    }
  }
}

}  // namespace isobench
