#include "isobench/experiments/plan/vertex_match.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace isobench {
namespace {

// Runs the search against a stand-in for a method.
VertexMatch search(double target, const std::function<double(double)>& vertices_at) {
  VertexMatch match(target);
  while (const std::optional<double> scale = match.next()) match.tried(*scale, vertices_at(*scale));
  return match;
}

TEST(VertexMatch, TakesTheSizingAsItIsWhereItAlreadyAgrees) {
  const VertexMatch match = search(1000.0, [](double) { return 1015.0; });
  EXPECT_EQ(match.tries(), 1U);
  EXPECT_EQ(match.best_scale(), 1.0);
  EXPECT_EQ(match.reason(), "");
}

TEST(VertexMatch, FindsTheScaleOfASurfaceAtTheSecondTry) {
  const VertexMatch match = search(50000.0, [](double s) { return std::round(21000.0 / (s * s)); });
  EXPECT_EQ(match.tries(), 2U);
  EXPECT_NEAR(match.best_scale(), std::sqrt(21.0 / 50.0), 1e-3);
  EXPECT_EQ(match.reason(), "");
}

TEST(VertexMatch, FollowsNumbersThatDoNotGoWithTheSquare) {
  // A floor makes the number change less and less; a method may need some vertices for corners, whatever the sizing.
  const auto with_corners = [](double s) { return 4000.0 + 1000.0 / std::pow(s, 1.4); };
  for (const double target : {4100.0, 5500.0, 20000.0, 300000.0}) {
    const VertexMatch match = search(target, with_corners);
    EXPECT_EQ(match.reason(), "") << target;
    EXPECT_NEAR(with_corners(match.best_scale()), target, 0.02 * target);
    EXPECT_LE(match.tries(), 8U) << target;
  }
}

TEST(VertexMatch, BisectsWhereTheNumberJumps) {
  // The numbers of red-green refinement: factors of four, with small steps in between.
  const auto steps = [](double s) {
    return std::round(5000.0 * std::pow(4.0, std::floor(-std::log2(s))) * (1.0 + 0.1 / s));
  };
  const VertexMatch match = search(26000.0, steps);
  EXPECT_EQ(match.reason(), "");
  EXPECT_NEAR(steps(match.best_scale()), 26000.0, 0.02 * 26000.0);
}

TEST(VertexMatch, GivesUpOnAMethodThatDoesNotFollow) {
  const VertexMatch match = search(50000.0, [](double) { return 18900.0; });
  EXPECT_EQ(match.tries(), 3U);
  EXPECT_EQ(match.best_scale(), 1.0);
  EXPECT_EQ(match.reason(), "its number of vertices does not follow the sizing");
}

TEST(VertexMatch, SaysHowFarOffTheNearestTryWas) {
  // Nothing between 900 and 1100.
  const VertexMatch match = search(1000.0, [](double s) { return s < 1.3 ? 1100.0 : 900.0; });
  EXPECT_EQ(match.tries(), VertexMatch::most_tries);
  EXPECT_EQ(match.reason(), "the nearest of 10 tries was 10.0 % off");
}

}  // namespace
}  // namespace isobench
