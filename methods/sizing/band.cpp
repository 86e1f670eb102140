#include "isobench/methods/sizing/band.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace isobench {

namespace {

constexpr int brick_edge = 4;

int bit_of(int i, int j, int k) { return (i & 3) | ((j & 3) << 2) | ((k & 3) << 4); }

std::size_t brick_of(const std::array<int, 3>& bricks, int i, int j, int k) {
  return (static_cast<std::size_t>(k >> 2) * static_cast<std::size_t>(bricks[1]) + static_cast<std::size_t>(j >> 2)) *
             static_cast<std::size_t>(bricks[0]) +
         static_cast<std::size_t>(i >> 2);
}

/// Calls visit(i, j, k) for every cell whose corners are not all on one side of the surface.
template <typename Visit>
void for_each_crossed_cell(const Isosurface& surface, Visit visit) {
  const auto [nx, ny, nz] = surface.lattice().size;
  std::vector<float> below;
  std::vector<float> above;
  surface.node_values(0, above);
  for (int k = 0; k + 1 < nz; ++k) {
    std::swap(below, above);
    surface.node_values(k + 1, above);
    for (int j = 0; j + 1 < ny; ++j) {
      const std::size_t row = static_cast<std::size_t>(j) * static_cast<std::size_t>(nx);
      const std::array<const float*, 4> rows{&below[row], &below[row + static_cast<std::size_t>(nx)], &above[row],
                                             &above[row + static_cast<std::size_t>(nx)]};
      int left = -1;
      for (int i = 0; i < nx; ++i) {
        int column = 0;
        for (const float* values : rows) column += values[i] > 0.0F ? 1 : 0;
        const int both = left + column;
        if (i > 0 && both != 0 && both != 8) visit(i - 1, j, k);
        left = column;
      }
    }
  }
}

}  // namespace

Band::Band(const Isosurface& surface, int margin) : size_(surface.lattice().size), spacing_(surface.lattice().spacing) {
  for (std::size_t axis = 0; axis < 3; ++axis) bricks_[axis] = (size_[axis] + brick_edge - 1) / brick_edge;
  mask_.assign(static_cast<std::size_t>(bricks_[0]) * static_cast<std::size_t>(bricks_[1]) *
                   static_cast<std::size_t>(bricks_[2]),
               0);
  const auto mark = [&](int i, int j, int k) {
    mask_[brick_of(bricks_, i, j, k)] |= std::uint64_t{1} << bit_of(i, j, k);
  };
  for_each_crossed_cell(surface, [&](int i, int j, int k) {
    for (int corner = 0; corner < 8; ++corner) mark(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2));
  });
  // A dilation by a box is three dilations, one along each axis.
  for (std::size_t axis = 0; axis < 3 && margin > 0; ++axis) {
    list_nodes();
    for (const std::array<int, 3>& node : nodes_) {
      std::array<int, 3> moved = node;
      for (int step = -margin; step <= margin; ++step) {
        moved[axis] = std::clamp(node[axis] + step, 0, size_[axis] - 1);
        mark(moved[0], moved[1], moved[2]);
      }
    }
  }
  list_nodes();
  nodes_.shrink_to_fit();
}

void Band::list_nodes() {
  nodes_.clear();
  offset_.assign(mask_.size(), 0);
  std::size_t brick = 0;
  for (int bk = 0; bk < bricks_[2]; ++bk) {
    for (int bj = 0; bj < bricks_[1]; ++bj) {
      for (int bi = 0; bi < bricks_[0]; ++bi, ++brick) {
        offset_[brick] = static_cast<std::int32_t>(nodes_.size());
        for (std::uint64_t rest = mask_[brick]; rest != 0; rest &= rest - 1) {
          const int bit = std::countr_zero(rest);
          nodes_.push_back({4 * bi + (bit & 3), 4 * bj + (bit >> 2 & 3), 4 * bk + (bit >> 4)});
        }
      }
    }
  }
}

std::int32_t Band::find(int i, int j, int k) const {
  if (i < 0 || j < 0 || k < 0 || i >= size_[0] || j >= size_[1] || k >= size_[2]) return -1;
  const std::size_t brick = brick_of(bricks_, i, j, k);
  const int bit = bit_of(i, j, k);
  const std::uint64_t mask = mask_[brick];
  if ((mask >> bit & 1) == 0) return -1;
  return offset_[brick] + std::popcount(mask & ((std::uint64_t{1} << bit) - 1));
}

Eigen::Vector3d Band::position(std::size_t n) const {
  const std::array<int, 3>& node = nodes_[n];
  return spacing_.cwiseProduct(Eigen::Vector3d(node[0], node[1], node[2]));
}

std::optional<double> Band::interpolate(const std::vector<float>& values, const Eigen::Vector3d& x) const {
  std::array<int, 3> cell{};
  Eigen::Vector3d t;
  for (int axis = 0; axis < 3; ++axis) {
    const int last = size_[static_cast<std::size_t>(axis)] - 1;
    const double u = std::clamp(x[axis] / spacing_[axis], 0.0, static_cast<double>(last));
    cell[static_cast<std::size_t>(axis)] = std::min(static_cast<int>(u), last - 1);
    t[axis] = u - cell[static_cast<std::size_t>(axis)];
  }
  double sum = 0.0;
  double weights = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const int di = corner & 1;
    const int dj = corner >> 1 & 1;
    const int dk = corner >> 2;
    const std::int32_t n = find(cell[0] + di, cell[1] + dj, cell[2] + dk);
    if (n < 0) continue;
    const double weight = (di == 1 ? t[0] : 1.0 - t[0]) * (dj == 1 ? t[1] : 1.0 - t[1]) * (dk == 1 ? t[2] : 1.0 - t[2]);
    sum += weight * static_cast<double>(values[static_cast<std::size_t>(n)]);
    weights += weight;
  }
  if (!(weights > 0.0)) return std::nullopt;
  return sum / weights;
}

}  // namespace isobench
