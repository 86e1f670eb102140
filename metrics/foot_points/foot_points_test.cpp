// Foot points and their mean curvature, against closed forms.
#include "isobench/metrics/foot_points/foot_points.h"

#include <gtest/gtest.h>

#include "isobench/metrics/foot_points/known_surfaces.h"
#include "isobench/metrics/test_surfaces.h"

namespace isobench {
namespace {

TEST(FootPoints, HaveTheMeanCurvatureOfAnEllipsoidAndATorus) {
  const Eigen::Vector3d axes(3.0, 2.0, 1.0);
  const Eigen::Vector3d direction = Eigen::Vector3d(1, 2, -2).normalized();
  const FootPoint foot = known_surfaces::feet({axes.cwiseProduct(direction)}, [&](const Eigen::Vector3d& x) {
                           return known_surfaces::ellipsoid(axes, x);
                         }).front();
  // H = (a² + b² + c² − |x|²) / (2 (abc)² (x²/a⁴ + y²/b⁴ + z²/c⁴)^(3/2)).
  const double slopes = (foot.x.array().square() / axes.array().pow(4)).sum();
  const double expected = (axes.squaredNorm() - foot.x.squaredNorm()) / (2.0 * 36.0 * std::pow(slopes, 1.5));
  EXPECT_NEAR(foot.mean_curvature(), expected, 1e-14);
  // The outer and the inner equator: (1/r ± 1/(R ± r))/2.
  const std::vector<FootPoint> equators = known_surfaces::feet({{0, 3.2, 0}, {0.9, 0, 0}}, known_surfaces::torus);
  EXPECT_NEAR(equators[0].mean_curvature(), 0.5 * (1.0 + 1.0 / 3.0), 1e-14);
  EXPECT_NEAR(equators[1].mean_curvature(), 0.5 * (1.0 - 1.0), 1e-14);
  EXPECT_LT((equators[1].normal() - Eigen::Vector3d(-1, 0, 0)).norm(), 1e-14);
}

TEST(FootPoints, LieOnTheSurface) {
  const Isosurface surface = ball();
  const std::vector<FootPoint> feet = foot_points(surface, {{20, 20, 31}, {30, 27, 20}, {20, 20, 20}});
  ASSERT_EQ(feet.size(), 3U);
  for (const FootPoint& foot : {feet[0], feet[1]}) {
    EXPECT_TRUE(foot.exists);
    EXPECT_NEAR(surface.value(foot.x), 0.0, 1e-8);
    EXPECT_LT((foot.normal() - (foot.x - Eigen::Vector3d(20, 20, 20)).normalized()).norm(), 1e-3);
    EXPECT_NEAR(foot.mean_curvature(), 1.0 / 12.0, 1e-3);
  }
  EXPECT_FALSE(feet[2].exists) << "at the ball's centre the gradient vanishes";
}

}  // namespace
}  // namespace isobench
