// Bumps of known size between the nodes.
#include "isobench/methods/sizing/critical_points/hidden_cells.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "isobench/methods/sizing/critical_points/critical_points.h"

namespace isobench {
namespace {

constexpr int lattice_nodes = 20;

/// A ball, so that there is a surface, and a bump with its peak in the middle of cell (14, 14, 14). All eight corners
/// of the cell have the same coefficient, so the peak is higher than the values at the corners.
Isosurface with_bump(float coefficient, Kernel kernel = Kernel::bspline) {
  FloatVolume volume;
  volume.lattice.size = {lattice_nodes, lattice_nodes, lattice_nodes};
  for (int k = 0; k < lattice_nodes; ++k) {
    for (int j = 0; j < lattice_nodes; ++j) {
      for (int i = 0; i < lattice_nodes; ++i) {
        const double ball = 4.0 - (Eigen::Vector3d(i, j, k) - Eigen::Vector3d::Constant(6.0)).norm();
        const bool bump = std::min({i, j, k}) >= 14 && std::max({i, j, k}) <= 15;
        volume.samples.push_back(bump ? coefficient : static_cast<float>(std::max(-1.0, ball)));
      }
    }
  }
  return {std::move(volume), 0.0, Inside::above, kernel};
}

/// The cells whose corners have one sign, but in which one of 7³ sample points has the other sign.
std::vector<std::array<int, 3>> seen_by_sampling(const Isosurface& surface) {
  constexpr int samples = 6;
  std::vector<std::array<int, 3>> found;
  for (int k = 0; k + 1 < lattice_nodes; ++k) {
    for (int j = 0; j + 1 < lattice_nodes; ++j) {
      for (int i = 0; i + 1 < lattice_nodes; ++i) {
        int corners = 0;
        int inside = 0;
        for (int n = 0; n < (samples + 1) * (samples + 1) * (samples + 1); ++n) {
          const Eigen::Vector3i at(n % (samples + 1), n / (samples + 1) % (samples + 1),
                                   n / ((samples + 1) * (samples + 1)));
          const bool is_inside = surface.value(Eigen::Vector3d(i, j, k) + at.cast<double>() / samples) > 0.0;
          inside += is_inside ? 1 : 0;
          const bool corner = at.unaryExpr([](int a) { return a % samples; }).sum() == 0;
          corners += corner && is_inside ? 1 : 0;
        }
        const int all = (samples + 1) * (samples + 1) * (samples + 1);
        if ((corners == 0 && inside > 0) || (corners == 8 && inside < all)) found.push_back({i, j, k});
      }
    }
  }
  return found;
}

TEST(HiddenCells, AreNoneWhereTheSurfaceIsFlatterThanTheLattice) {
  // A plane along the lattice crosses each cell between its corners, so no cell is hidden.
  FloatVolume volume;
  volume.lattice.size = {lattice_nodes, lattice_nodes, lattice_nodes};
  for (int n = 0; n < lattice_nodes * lattice_nodes * lattice_nodes; ++n)
    volume.samples.push_back(static_cast<float>(n % lattice_nodes) - 9.3F);
  EXPECT_TRUE(hidden_cells(Isosurface(std::move(volume), 0.0)).empty());
}

TEST(HiddenCells, AreAllThatSamplingFinds) {
  for (const Kernel kernel : {Kernel::bspline, Kernel::interpolating_bspline, Kernel::catmull_rom}) {
    std::size_t seen = 0;
    for (const float coefficient : {-0.1F, 0.2F, 0.45F, 0.7F}) {
      const Isosurface surface = with_bump(coefficient, kernel);
      const auto found = hidden_cells(surface);
      for (const auto& cell : seen_by_sampling(surface)) {
        ++seen;
        EXPECT_NE(std::find(found.begin(), found.end(), cell), found.end())
            << to_string(kernel) << " " << coefficient << ": " << cell[0] << " " << cell[1] << " " << cell[2];
      }
    }
    EXPECT_GT(seen, 0U) << to_string(kernel);
  }
}

TEST(HiddenCells, HaveThePeakOfASpeckThatNoNodeShows) {
  // The bump rises above −1 by `step` · (1/6 + 4/6)³ at the nodes and by `step` · (23/24)³ in the middle of the cell. f
  // is negative at the nodes and positive in the middle.
  const double step = 1.45;
  ASSERT_LT(step * std::pow(5.0 / 6.0, 3) - 1.0, 0.0);
  const Isosurface surface = with_bump(static_cast<float>(step - 1.0));
  const auto found = critical_points(surface, Band(surface, 2), 1e-9);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_LT((found[0].position - Eigen::Vector3d::Constant(14.5)).norm(), 1e-6);
  EXPECT_EQ(found[0].falling, 3);
  EXPECT_NEAR(found[0].value, step * std::pow(23.0 / 24.0, 3) - 1.0, 1e-6);
}

TEST(HiddenCells, AreTheSameForAnyNumberOfThreads) {
  const Isosurface surface = with_bump(0.45F);
  const auto many = hidden_cells(surface);
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(hidden_cells(surface), many);
}

}  // namespace
}  // namespace isobench
