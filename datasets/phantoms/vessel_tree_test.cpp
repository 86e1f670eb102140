#include "isobench/datasets/phantoms/vessel_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "isobench/datasets/phantoms/phantoms.h"

namespace isobench {
namespace {

using Eigen::Vector3d;

const std::vector<VesselSegment>& tree = vessel_tree();

/// The segments that grow from this one.
std::vector<const VesselSegment*> branches_of(std::size_t parent) {
  std::vector<const VesselSegment*> found;
  for (const VesselSegment& s : tree) {
    if (s.parent == static_cast<int>(parent)) found.push_back(&s);
  }
  return found;
}

TEST(VesselTree, BranchesThreeTimesByMurraysLaw) {
  ASSERT_EQ(tree.size(), 15U);
  int tips = 0;
  for (std::size_t n = 0; n < tree.size(); ++n) {
    const auto branches = branches_of(n);
    const double r0 = tree[n].radius_to;
    if (branches.empty()) {
      ++tips;
      continue;
    }
    ASSERT_EQ(branches.size(), 2U);
    double flow = 0.0;
    Vector3d pull = Vector3d::Zero();
    for (const VesselSegment* s : branches) {
      EXPECT_EQ(s->from, tree[n].to);
      EXPECT_EQ(s->radius_from, r0);
      EXPECT_LT(s->radius_to, r0);
      flow += std::pow(s->radius_to, 3);
      pull += s->radius_to * s->radius_to * (s->to - s->from).normalized();
    }
    EXPECT_NEAR(flow, std::pow(r0, 3), 1e-9);
    // With Murray's angles the branching point is in equilibrium: the pulls along the segments, each r², cancel.
    EXPECT_LT((pull - r0 * r0 * (tree[n].to - tree[n].from).normalized()).norm(), 1e-9);
  }
  EXPECT_EQ(tips, 8);
  EXPECT_NEAR(*phantom("vessel-tree").smallest_radius, 1.6, 1e-12);
}

// If no branch touches another one, the tree is contractible, in one piece and without tunnels, and χ is 2.
TEST(VesselTree, BranchesMeetNowhereElse) {
  for (std::size_t n = 0; n < tree.size(); ++n) {
    for (std::size_t m = 0; m < n; ++m) {
      if (tree[n].parent == static_cast<int>(m) || tree[n].parent == tree[m].parent) continue;
      for (double t = 0.0; t <= 1.0; t += 1.0 / 256.0) {
        const Vector3d centre = tree[n].from + t * (tree[n].to - tree[n].from);
        const double radius = tree[n].radius_from + t * (tree[n].radius_to - tree[n].radius_from);
        // 5 mm: three voxels of a lattice of 48 nodes.
        EXPECT_GT(-depth_in(tree[m], centre) - radius, 5.0) << n << " and " << m;
      }
    }
  }
}

TEST(VesselTree, OutsideItIsTheDistanceToTheNearestBall) {
  const Phantom& p = phantom("vessel-tree");
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(-1.2, 1.2);
  int tried = 0;
  while (tried < 500) {
    const Vector3d x = Vector3d(unit(random), unit(random), unit(random)).cwiseProduct(p.half_extent);
    if (p.function(x) > 0.0) continue;
    ++tried;
    double nearest = 1e9;
    for (const VesselSegment& s : tree) {
      for (int step = 0; step <= 2000; ++step) {
        const double t = step / 2000.0;
        const double radius = s.radius_from + t * (s.radius_to - s.radius_from);
        nearest = std::min(nearest, (x - s.from - t * (s.to - s.from)).norm() - radius);
      }
    }
    // With centres 0.01 mm apart the error is (0.005 mm)²/2 divided by the distance to the nearest, at least 1.6 mm.
    EXPECT_NEAR(-p.function(x), nearest, 1e-5) << x.transpose();
  }
}

}  // namespace
}  // namespace isobench
