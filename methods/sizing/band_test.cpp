#include "isobench/methods/sizing/band.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <vector>

#include "isobench/datasets/phantoms/phantoms.h"

namespace isobench {
namespace {

Isosurface coarse_torus() { return Isosurface(sample_phantom(phantom("torus"), 30), 0.0); }

/// The same nodes from the definition, node by node.
std::set<std::array<int, 3>> nodes_near_crossed_cells(const Isosurface& surface, int margin) {
  const int nx = surface.lattice().size[0];
  const int ny = surface.lattice().size[1];
  const int nz = surface.lattice().size[2];
  std::vector<std::vector<float>> slabs(static_cast<std::size_t>(nz));
  for (int k = 0; k < nz; ++k) surface.node_values(k, slabs[static_cast<std::size_t>(k)]);
  const auto inside = [&](int i, int j, int k) {
    return slabs[static_cast<std::size_t>(k)][surface.lattice().index(i, j, 0)] > 0.0F;
  };
  std::set<std::array<int, 3>> nodes;
  for (int k = 0; k + 1 < nz; ++k) {
    for (int j = 0; j + 1 < ny; ++j) {
      for (int i = 0; i + 1 < nx; ++i) {
        int corners = 0;
        for (int c = 0; c < 8; ++c) corners += inside(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)) ? 1 : 0;
        if (corners == 0 || corners == 8) continue;
        for (int dk = -margin; dk <= margin + 1; ++dk) {
          for (int dj = -margin; dj <= margin + 1; ++dj) {
            for (int di = -margin; di <= margin + 1; ++di) {
              nodes.insert(
                  {std::clamp(i + di, 0, nx - 1), std::clamp(j + dj, 0, ny - 1), std::clamp(k + dk, 0, nz - 1)});
            }
          }
        }
      }
    }
  }
  return nodes;
}

TEST(Band, HoldsTheNodesOfItsDefinition) {
  const Isosurface surface = coarse_torus();
  for (const int margin : {0, 2}) {
    const Band band(surface, margin);
    std::set<std::array<int, 3>> found;
    for (std::size_t n = 0; n < band.size(); ++n) found.insert(band.node(n));
    EXPECT_EQ(found.size(), band.size()) << "no node twice";
    EXPECT_EQ(found, nodes_near_crossed_cells(surface, margin)) << "margin " << margin;
  }
}

TEST(Band, FindsEveryNodeByItsIndicesAndNoOther) {
  const Isosurface surface = coarse_torus();
  const Band band(surface, 1);
  std::size_t found = 0;
  for (int k = -1; k <= surface.lattice().size[2]; ++k) {
    for (int j = -1; j <= surface.lattice().size[1]; ++j) {
      for (int i = -1; i <= surface.lattice().size[0]; ++i) {
        const std::int32_t n = band.find(i, j, k);
        if (n < 0) continue;
        ++found;
        EXPECT_EQ(band.node(static_cast<std::size_t>(n)), (std::array<int, 3>{i, j, k}));
      }
    }
  }
  EXPECT_EQ(found, band.size());
}

TEST(Band, InterpolatesTrilinearFieldsExactly) {
  const Isosurface surface = coarse_torus();
  const Band band(surface, 2);
  const auto field = [](const Eigen::Vector3d& x) { return 1.0 + 0.5 * x[0] - 0.25 * x[1] + 2.0 * x[2]; };
  std::vector<float> values(band.size());
  for (std::size_t n = 0; n < band.size(); ++n) values[n] = static_cast<float>(field(band.position(n)));
  const Band crossed(surface, 0);
  for (std::size_t n = 0; n < crossed.size(); ++n) {
    const Eigen::Vector3d x = crossed.position(n) + 0.3 * surface.lattice().spacing;
    ASSERT_TRUE(band.interpolate(values, x));
    EXPECT_NEAR(*band.interpolate(values, x), field(x), 1e-5 * std::abs(field(x)) + 1e-5);  // values are floats
  }
  EXPECT_FALSE(band.interpolate(values, Eigen::Vector3d::Zero())) << "the lattice's corner is far from the torus";
}

}  // namespace
}  // namespace isobench
