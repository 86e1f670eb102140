#include "isobench/metrics/reaction_diffusion/surface_area.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace isobench {

namespace {

using Slabs = std::array<std::vector<float>, 3>;

/// The sum over the inner nodes of the middle slab, over the volume of a cell.
double of_slab(const Slabs& slabs, const std::array<int, 3>& size, const Eigen::Array3d& spacing) {
  const auto& [below, middle, above] = slabs;
  const auto row = static_cast<std::size_t>(size[0]);
  double sum = 0.0;
  for (int j = 1; j + 1 < size[1]; ++j) {
    for (int i = 1; i + 1 < size[0]; ++i) {
      const std::size_t n = static_cast<std::size_t>(j) * row + static_cast<std::size_t>(i);
      const Eigen::Array3d change(0.5 * (middle[n + 1] - middle[n - 1]), 0.5 * (middle[n + row] - middle[n - row]),
                                  0.5 * (above[n] - below[n]));
      const double width = change.abs().sum();
      const double within = width - std::abs(static_cast<double>(middle[n]));
      if (within > 0.0) sum += (change / spacing).matrix().norm() * within / (width * width);
    }
  }
  return sum;
}

}  // namespace

double surface_area(const Isosurface& surface) {
  constexpr int block = 16;  // slabs; a block computes two more than it sums
  const Lattice& lattice = surface.lattice();
  const Eigen::Array3d spacing = lattice.spacing;
  const int inner = std::max(lattice.size[2] - 2, 0);
  std::vector<double> sums(static_cast<std::size_t>((inner + block - 1) / block), 0.0);
  tbb::parallel_for(std::size_t{0}, sums.size(), [&](std::size_t b) {
    const int first = 1 + static_cast<int>(b) * block;
    Slabs slabs;
    surface.node_values(first - 1, slabs[1]);
    surface.node_values(first, slabs[2]);
    for (int k = first; k < std::min(first + block, inner + 1); ++k) {
      std::rotate(slabs.begin(), slabs.begin() + 1, slabs.end());
      surface.node_values(k + 1, slabs[2]);
      sums[b] += of_slab(slabs, lattice.size, spacing);
    }
  });
  double sum = 0.0;
  for (const double part : sums) sum += part;
  return sum * spacing.prod();
}

}  // namespace isobench
