#include "isobench/datasets/preparation/needed_steps.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "isobench/foundation/error.h"

namespace isobench {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Volume line_of(Samples samples) {
  Volume volume;
  volume.lattice.size = {static_cast<int>(samples.size()), 1, 1};
  volume.samples = std::move(samples);
  return volume;
}

std::string chain(const std::vector<PrepareStep>& steps, const Volume& volume) {
  std::string text;
  for (const PrepareStep& step : with_needed_steps(steps, volume, 7.0, true)) {
    const std::string name = describe(step);
    text += name.substr(0, name.find_first_of(" :,")) + " ";
  }
  return text;
}

Lattice sheared(double degrees) {
  Lattice lattice;
  lattice.size = {20, 16, 12};
  lattice.spacing = {1.0, 1.0, 1.5 / std::cos(degrees * M_PI / 180.0)};
  lattice.origin = {-10.0, 5.0, 3.0};
  lattice.direction.col(2) = Eigen::Vector3d(0.0, std::sin(degrees * M_PI / 180.0), std::cos(degrees * M_PI / 180.0));
  return lattice;
}

TEST(FillOutside, TakesTheFarthestValueOutside) {
  Monitor monitor;
  const Volume filled =
      prepare(line_of(std::vector<double>{nan, 5.0, -infinity, -3.0, 9.0}), {FillOutside{2.0}}, monitor);
  EXPECT_EQ(filled.samples.as<double>(), (std::vector<double>{-3.0, 5.0, -3.0, -3.0, 9.0}));
  ASSERT_EQ(monitor.notes().size(), 1U);
  EXPECT_NE(monitor.notes().front().find("2 of 5 samples"), std::string::npos);
}

TEST(FillOutside, OfAnObjectBelowIsAbove) {
  Monitor monitor;
  const Volume filled =
      prepare(line_of(std::vector<float>{NAN, 5.0F, INFINITY, 1.0F}), {FillOutside{2.0, true}}, monitor);
  EXPECT_EQ(filled.samples.as<float>(), (std::vector<float>{5.0F, 5.0F, 5.0F, 1.0F}));
}

// The file holds the object alone: the value is as far outside as the object's middle is inside.
TEST(FillOutside, LiesOutsideWhereAllSamplesAreInside) {
  Monitor monitor;
  const Volume filled = prepare(line_of(std::vector<float>{NAN, 3.0F, 5.0F}), {FillOutside{2.0}}, monitor);
  EXPECT_EQ(filled.samples.as<float>().front(), 0.0F);
}

TEST(FillOutside, RefusesInfinityOnTheObjectsSide) {
  Monitor monitor;
  EXPECT_THROW(prepare(line_of(std::vector<float>{INFINITY, 5.0F, 1.0F}), {FillOutside{2.0}}, monitor), DataError);
  EXPECT_THROW(prepare(line_of(std::vector<float>{-INFINITY, 5.0F, 1.0F}), {FillOutside{2.0, true}}, monitor),
               DataError);
  EXPECT_THROW(prepare(line_of(std::vector<float>{NAN, NAN}), {FillOutside{2.0}}, monitor), DataError);
}

TEST(NeededSteps, AreNoneForAnOrdinaryVolume) {
  EXPECT_EQ(chain({Gaussian{Eigen::Vector3d::Ones()}}, line_of(std::vector<float>{1.0F, 2.0F})), "gaussian ");
  Volume rounded{sheared(0.1), std::vector<std::uint8_t>(20UL * 16 * 12, 1)};
  EXPECT_EQ(chain({}, rounded), "");
}

TEST(NeededSteps, ComeBeforeTheFirstStepThatNeedsThem) {
  const Volume hollow = line_of(std::vector<float>{1.0F, NAN});
  EXPECT_EQ(chain({}, hollow), "fill-outside ");
  EXPECT_EQ(chain({Cut{}, Gaussian{Eigen::Vector3d::Ones()}}, hollow), "cut fill-outside gaussian ");
  EXPECT_EQ(chain({Threshold{}, Gaussian{Eigen::Vector3d::Ones()}}, hollow), "threshold gaussian ");
  EXPECT_EQ(chain({SelectLabels{{1}}}, hollow), "labels ");
  const Volume tilted{sheared(10.0), std::vector<float>(20UL * 16 * 12, NAN)};
  EXPECT_EQ(chain({Cut{}, Gaussian{Eigen::Vector3d::Ones()}}, tilted), "cut fill-outside rectangular gaussian ");
  EXPECT_EQ(chain({SelectLabels{{1}}, SignedDistance{}}, tilted), "labels rectangular signed-distance ");
}

TEST(Rectangular, KeepsALinearFieldInPlace) {
  for (const double degrees : {12.0, -25.0}) {
    SCOPED_TRACE(degrees);
    const Lattice lattice = sheared(degrees);
    const auto value_at = [](const Eigen::Vector3d& x) { return 100.0 + x.dot(Eigen::Vector3d(1.0, -2.0, 0.5)); };
    FloatVolume volume{lattice, std::vector<float>(lattice.nodes())};
    for (int k = 0; k < lattice.size[2]; ++k) {
      for (int j = 0; j < lattice.size[1]; ++j) {
        for (int i = 0; i < lattice.size[0]; ++i)
          volume.at(i, j, k) =
              static_cast<float>(value_at(lattice.to_world(lattice.spacing.cwiseProduct(Eigen::Vector3d(i, j, k)))));
      }
    }
    Monitor monitor;
    const FloatVolume result = as_float(prepare(volume, {Rectangular{0.0}}, monitor));
    EXPECT_TRUE(result.lattice.is_rectangular());
    EXPECT_LT((result.lattice.direction.transpose() * result.lattice.direction - Eigen::Matrix3d::Identity()).norm(),
              1e-12);
    // Slices stay where they are, and old nodes that are new ones, too.
    EXPECT_EQ(result.lattice.size[2], lattice.size[2]);
    EXPECT_NEAR(result.lattice.spacing[2], 1.5, 1e-12);
    std::size_t within = 0;
    for (int k = 0; k < result.lattice.size[2]; ++k) {
      for (int j = 0; j < result.lattice.size[1]; ++j) {
        for (int i = 0; i < result.lattice.size[0]; ++i) {
          const Eigen::Vector3d x =
              result.lattice.to_world(result.lattice.spacing.cwiseProduct(Eigen::Vector3d(i, j, k)));
          const Eigen::Vector3d old = lattice.to_local(x).cwiseQuotient(lattice.spacing);
          const Eigen::Vector3d last(lattice.size[0] - 1, lattice.size[1] - 1, lattice.size[2] - 1);
          if ((old.array() > 1e-6).all() && (old.array() < last.array() - 1e-6).all()) {
            EXPECT_NEAR(result.at(i, j, k), value_at(x), 1e-3);
            ++within;
          } else if ((old.array() < -1e-3).any() || (old.array() > last.array() + 1e-3).any()) {
            EXPECT_LT(result.at(i, j, k), 0.0F);
          }
        }
      }
    }
    EXPECT_GT(within, lattice.nodes() / 2);
  }
}

}  // namespace
}  // namespace isobench
