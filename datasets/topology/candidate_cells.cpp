#include "isobench/datasets/topology/candidate_cells.h"

#include <algorithm>
#include <cstddef>

namespace isobench {

namespace {

/// If the coefficients are within [m, M], so is a B-spline. The negative weights of Catmull-Rom sum to at most
/// (1.25³ − 1)/2 in magnitude.
constexpr double catmull_rom_overshoot = (1.25 * 1.25 * 1.25 - 1.0) / 2.0;

/// Bounds of the coefficients that F in each cell of a layer depends on: nodes −1 to +2 along each axis.
struct CoefficientBounds {
  std::vector<float> least;
  std::vector<float> most;

  /// Widens the bounds along a line of `count` values that are `step` apart. Nodes beyond its ends repeat the last
  /// ones.
  void widen(std::size_t first, std::size_t count, std::size_t step) {
    slide(least, first, count, step, [](float a, float b) { return std::min(a, b); });
    slide(most, first, count, step, [](float a, float b) { return std::max(a, b); });
  }

 private:
  template <class Choose>
  static void slide(std::vector<float>& values, std::size_t first, std::size_t count, std::size_t step, Choose choose) {
    float before = values[first];
    for (std::size_t n = 0; n < count; ++n) {
      float& here = values[first + n * step];
      float chosen = choose(before, here);
      before = here;
      if (n + 1 < count) chosen = choose(chosen, values[first + (n + 1) * step]);
      if (n + 2 < count) chosen = choose(chosen, values[first + (n + 2) * step]);
      here = chosen;
    }
  }
};

/// Those of cell (i, j, k) are at i + j · size[0].
CoefficientBounds bounds_of_layer(const Isosurface& surface, int k) {
  const auto columns = static_cast<std::size_t>(surface.lattice().size[0]);
  const auto rows = static_cast<std::size_t>(surface.lattice().size[1]);
  CoefficientBounds bounds{std::vector<float>(columns * rows), std::vector<float>(columns * rows)};
  for (std::size_t n = 0; n < columns * rows; ++n) {
    const int i = static_cast<int>(n % columns);
    const int j = static_cast<int>(n / columns);
    const auto [least, most] = std::minmax({surface.coefficient(i, j, k - 1), surface.coefficient(i, j, k),
                                            surface.coefficient(i, j, k + 1), surface.coefficient(i, j, k + 2)});
    bounds.least[n] = least;
    bounds.most[n] = most;
  }
  for (std::size_t j = 0; j < rows; ++j) bounds.widen(j * columns, columns, 1);
  for (std::size_t i = 0; i < columns; ++i) bounds.widen(i, rows, columns);
  return bounds;
}

}  // namespace

std::vector<std::array<int, 2>> candidate_cells(const Isosurface& surface, int k, double low, double high) {
  const CoefficientBounds bounds = bounds_of_layer(surface, k);
  const double overshoot = surface.kernel() == Kernel::catmull_rom ? catmull_rom_overshoot : 0.0;
  const std::array<int, 3>& size = surface.lattice().size;
  std::vector<std::array<int, 2>> found;
  for (int j = 0; j + 1 < size[1]; ++j) {
    for (int i = 0; i + 1 < size[0]; ++i) {
      const std::size_t n =
          static_cast<std::size_t>(j) * static_cast<std::size_t>(size[0]) + static_cast<std::size_t>(i);
      const double least = bounds.least[n];
      const double most = bounds.most[n];
      const double beyond = overshoot * (most - least);
      if (least - beyond <= high && most + beyond >= low) found.push_back({i, j});
    }
  }
  return found;
}

}  // namespace isobench
