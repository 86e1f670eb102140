#include "isobench/methods/particles/cure/dual_edge_crossings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "isobench/datasets/phantoms/phantoms.h"

namespace isobench::particles {
namespace {

using Eigen::Vector3d;

class DualEdgeTest : public ::testing::Test {
 protected:
  const Isosurface surface{sample_phantom(phantom("two-spheres"), 48), 0.0};

  LabelledDelaunay::Facet between(const Vector3d& inside, const Vector3d& outside) const {
    return {{0, 1, 2}, inside, outside};
  }
  // The node with the largest f.
  Vector3d deepest() const {
    Vector3d best = Vector3d::Zero();
    for (int k = 0; k < 48; ++k) {
      for (int j = 0; j < 48; ++j) {
        for (int i = 0; i < 48; ++i) {
          const Vector3d x = Vector3d(i, j, k).cwiseProduct(surface.lattice().spacing);
          if (surface.value(x) > surface.value(best)) best = x;
        }
      }
    }
    return best;
  }
};

TEST_F(DualEdgeTest, CrossesOnceFromInsideToOutside) {
  const Vector3d centre = deepest();
  ASSERT_GT(surface.value(centre), 0.0);
  for (const Vector3d& to : {Vector3d(0, 0, 0), Vector3d(centre[0], centre[1], 0), Vector3d(centre[0], 0, centre[2])}) {
    const auto facet = between(centre, to);
    EXPECT_EQ(count_crossings(facet, surface), 1);
    const std::vector<Vector3d> points = crossing_points(facet, surface);
    ASSERT_EQ(points.size(), 1U);
    const Jet jet = surface.value_gradient(points[0]);
    EXPECT_LT(std::abs(jet.value) / jet.gradient.norm(), 1e-6 * surface.voxel());
    const Vector3d way = (to - centre).normalized();
    const Vector3d off = points[0] - centre - way * way.dot(points[0] - centre);
    EXPECT_LT(off.norm(), surface.voxel());
  }
}

TEST_F(DualEdgeTest, CrossesThreeTimesThroughTheOtherSphere) {
  const Vector3d centre = deepest();
  // The other sphere is along x; the direction depends on which sphere has the larger f.
  const double end = centre[0] < 0.5 * surface.extent()[0] ? surface.extent()[0] : 0.0;
  const auto facet = between(centre, {end, centre[1], centre[2]});
  EXPECT_EQ(count_crossings(facet, surface), 3);
  const std::vector<Vector3d> points = crossing_points(facet, surface);
  ASSERT_EQ(points.size(), 3U);
  EXPECT_LT(std::abs(points[0][0] - centre[0]), std::abs(points[1][0] - centre[0]));
  EXPECT_LT(std::abs(points[1][0] - centre[0]), std::abs(points[2][0] - centre[0]));
}

TEST_F(DualEdgeTest, DoesNotCrossBeyondTheVolume) {
  const Vector3d centre = deepest();
  const Vector3d far = centre + 1000.0 * (Vector3d(0, 0, 0) - centre);
  EXPECT_EQ(count_crossings(between(centre, far), surface), 1);
}

TEST_F(DualEdgeTest, DoesNotCrossWithinTheObject) {
  const Vector3d centre = deepest();
  const auto facet = between(centre, centre + Vector3d::Constant(surface.voxel()));
  EXPECT_EQ(count_crossings(facet, surface), 0);
  EXPECT_TRUE(crossing_points(facet, surface).empty());
}

}  // namespace
}  // namespace isobench::particles
