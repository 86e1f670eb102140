#include "isobench/methods/particles/relaxation/potential.h"

#include <gtest/gtest.h>

#include <cmath>

namespace isobench::particles {
namespace {

TEST(Potential, HasTheIdealPackingsValueAtBeta) {
  EXPECT_NEAR(beta, 0.5 / std::cos(std::acos(-1.0) / 6.0), 1e-15);
  EXPECT_NEAR(6.0 * potential(beta), ideal_energy, 1e-11);
}

TEST(Potential, AndItsDerivativeVanishAtTheSecondRing) {
  EXPECT_NEAR(potential(1.0 - 1e-9), 0.0, 1e-12);
  EXPECT_NEAR(potential_derivative(1.0 - 1e-9), 0.0, 1e-12);
  EXPECT_EQ(potential(1.0), 0.0);
  EXPECT_EQ(potential(1.7), 0.0);
}

TEST(Potential, HasTheDerivativesOfItsDifferences) {
  constexpr double step = 1e-5;  // differences err by step² times the third derivative
  for (double d = 0.2; d < 0.99; d += 0.05) {
    const double first = (potential(d + step) - potential(d - step)) / (2.0 * step);
    const double second = (potential_derivative(d + step) - potential_derivative(d - step)) / (2.0 * step);
    EXPECT_NEAR(potential_derivative(d), first, 1e-6 * std::abs(first) + 1e-8);
    EXPECT_NEAR(potential_second_derivative(d), second, 1e-6 * std::abs(second) + 1e-8);
  }
}

// The table is linear between 2048 entries, so its error is (1/2155)²/8 times the second derivative: below 1e-4 at the
// distances at which particles are.
TEST(PotentialTable, FollowsTheFormulas) {
  const PotentialTable& table = PotentialTable::instance();
  for (double d = 0.2; d < 0.999; d += 0.0137) {
    const PotentialTable::Entry entry = table.at(d);
    EXPECT_NEAR(entry.energy, potential(d), 1e-4 * potential(d) + 1e-6);
    EXPECT_NEAR(entry.derivative, potential_derivative(d), 1e-4 * std::abs(potential_derivative(d)) + 1e-6);
    const double stiffness = 0.5 * std::max(0.0, potential_second_derivative(d) + potential_derivative(d) / d);
    EXPECT_NEAR(entry.stiffness, stiffness, 1e-3 * stiffness + 1e-3);  // it has a kink where the maximum takes over
  }
  EXPECT_EQ(table.at(0.0).energy, table.at(0.05).energy) << "the table begins at 0.05";
}

}  // namespace
}  // namespace isobench::particles
