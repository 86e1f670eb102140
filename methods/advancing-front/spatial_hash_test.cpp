#include "isobench/methods/advancing-front/spatial_hash.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace isobench::advancing_front {
namespace {

struct Ball {
  Eigen::Vector3d centre;
  double radius;
  bool in;
};

TEST(SpatialHash, FindsEverythingThatReachesIntoABallWhileItemsComeAndGo) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto point = [&] {
    return Eigen::Vector3d(20.0 * unit(random) - 5.0, 20.0 * unit(random), 20.0 * unit(random));
  };
  SpatialHash hash(0.05);
  std::vector<Ball> balls;
  for (int n = 0; n < 4000; ++n) {
    balls.push_back({point(), 0.02 * std::pow(50.0, unit(random)), true});
    hash.insert(n, balls.back().centre, balls.back().radius, 0.0);
    const auto gone = static_cast<std::size_t>(unit(random) * n);
    if (n % 3 == 0 && balls[gone].in) {
      hash.erase(static_cast<int>(gone));
      balls[gone].in = false;
    }
  }
  hash.erase(123456);  // was never inserted
  for (int query = 0; query < 200; ++query) {
    const Eigen::Vector3d centre = point();
    const double radius = 2.0 * unit(random);
    std::vector<int> found;
    hash.near(centre, radius, 0.0, found);
    const std::set<int> unique(found.begin(), found.end());
    EXPECT_EQ(unique.size(), found.size());
    for (int n = 0; n < 4000; ++n) {
      const Ball& ball = balls[static_cast<std::size_t>(n)];
      if (!ball.in) {
        EXPECT_EQ(unique.count(n), 0U);
      } else if ((ball.centre - centre).norm() <= radius + ball.radius) {
        EXPECT_EQ(unique.count(n), 1U) << "item " << n;
      }
    }
  }
}

TEST(SpatialHash, LeavesOutOnlyWhatIsSmallInASmallNeighbourhood) {
  SpatialHash hash(0.05);
  hash.insert(0, {0.0, 0.0, 0.0}, 0.01, 0.02);
  hash.insert(1, {0.0, 0.0, 0.0}, 0.01, 1.0);
  hash.insert(2, {0.0, 0.0, 0.0}, 0.6, 0.02);
  std::vector<int> found;
  hash.near({0.1, 0.0, 0.0}, 0.2, 0.5, found);
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, (std::vector<int>{1, 2}));
}

}  // namespace
}  // namespace isobench::advancing_front
