#include "isobench/methods/particles/sampling/neighbours.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "isobench/foundation/random.h"

namespace isobench::particles {
namespace {

struct Cloud {
  std::vector<Eigen::Vector3d> points;
  std::vector<double> reach;
};

/// Random points in a box. Reaches span five octaves; points with a small reach cluster in a corner.
Cloud random_cloud(std::size_t count) {
  Cloud cloud;
  for (std::size_t n = 0; n < count; ++n) {
    const double octave = std::floor(5.0 * uniform_random(7, n, 3));
    const double size = 20.0 * std::exp2(octave - 4.0);
    cloud.points.emplace_back(size * uniform_random(7, n, 0), size * uniform_random(7, n, 1),
                              size * uniform_random(7, n, 2));
    cloud.reach.push_back(0.15 * std::exp2(octave) * (0.7 + 0.6 * uniform_random(7, n, 4)));
  }
  return cloud;
}

TEST(Neighbours, AgreeWithABruteForceSearch) {
  const Cloud cloud = random_cloud(1500);
  const NeighbourLists lists = find_neighbours(cloud.points, cloud.reach);
  std::size_t pairs = 0;
  for (std::uint32_t i = 0; i < cloud.points.size(); ++i) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t j = 0; j < cloud.points.size(); ++j) {
      const double limit = std::min(cloud.reach[i], cloud.reach[j]);
      if (j != i && (cloud.points[i] - cloud.points[j]).norm() < limit) expected.push_back(j);
    }
    std::vector<std::uint32_t> found(lists.of(i).begin(), lists.of(i).end());
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, expected) << "of particle " << i;
    pairs += found.size();
  }
  EXPECT_GT(pairs, 2000U) << "too few pairs for a meaningful test";
}

TEST(Neighbours, ComeInTheSameOrderForAnyNumberOfThreads) {
  const Cloud cloud = random_cloud(20000);
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return find_neighbours(cloud.points, cloud.reach);
  };
  const NeighbourLists one = with_threads(1);
  const NeighbourLists four = with_threads(4);
  EXPECT_EQ(one.first, four.first);
  EXPECT_EQ(one.items, four.items);
}

TEST(Neighbours, OfNoParticlesOrOneAreNone) {
  EXPECT_TRUE(find_neighbours({}, {}).items.empty());
  EXPECT_TRUE(find_neighbours({Eigen::Vector3d(1, 2, 3)}, {1.0}).of(0).empty());
}

}  // namespace
}  // namespace isobench::particles
