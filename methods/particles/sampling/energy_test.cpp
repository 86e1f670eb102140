#include "isobench/methods/particles/sampling/energy.h"

#include <gtest/gtest.h>

#include <cmath>

namespace isobench::particles {
namespace {

TEST(PairEnergy, HasTheIdealPackingsValueAtBeta) {
  EXPECT_NEAR(beta, 0.5 / std::cos(std::acos(-1.0) / 6.0), 1e-15);
  EXPECT_NEAR(6.0 * pair_energy(beta), ideal_energy, 1e-11);
}

TEST(PairEnergy, AndItsSlopeVanishAtTheSecondRing) {
  EXPECT_NEAR(pair_energy(1.0 - 1e-9), 0.0, 1e-12);
  EXPECT_NEAR(pair_energy_first(1.0 - 1e-9), 0.0, 1e-12);
  EXPECT_EQ(pair_energy(1.0), 0.0);
  EXPECT_EQ(pair_energy(1.7), 0.0);
}

TEST(PairEnergy, DerivativesAreThoseOfTheEnergy) {
  constexpr double step = 1e-5;  // differences err by step² times the third derivative
  for (double d = 0.2; d < 0.99; d += 0.05) {
    const double first = (pair_energy(d + step) - pair_energy(d - step)) / (2.0 * step);
    const double second = (pair_energy_first(d + step) - pair_energy_first(d - step)) / (2.0 * step);
    EXPECT_NEAR(pair_energy_first(d), first, 1e-6 * std::abs(first) + 1e-8);
    EXPECT_NEAR(pair_energy_second(d), second, 1e-6 * std::abs(second) + 1e-8);
  }
}

// Linear between 2048 entries: the error is (1/2155)²/8 times the second derivative, below 1e-4 where particles stand.
TEST(PotentialTable, FollowsTheFormulas) {
  const PotentialTable& table = PotentialTable::instance();
  for (double d = 0.2; d < 0.999; d += 0.0137) {
    const PotentialTable::Entry entry = table.at(d);
    EXPECT_NEAR(entry.energy, pair_energy(d), 1e-4 * pair_energy(d) + 1e-6);
    EXPECT_NEAR(entry.first, pair_energy_first(d), 1e-4 * std::abs(pair_energy_first(d)) + 1e-6);
    const double stiffness = 0.5 * std::max(0.0, pair_energy_second(d) + pair_energy_first(d) / d);
    EXPECT_NEAR(entry.stiffness, stiffness, 1e-3 * stiffness + 1e-3);  // it has a kink where the maximum takes over
  }
  EXPECT_EQ(table.at(0.0).energy, table.at(0.05).energy) << "the table ends below";
}

}  // namespace
}  // namespace isobench::particles
