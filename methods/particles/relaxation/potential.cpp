#include "isobench/methods/particles/relaxation/potential.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isobench::particles {

namespace {

constexpr double half_pi = std::numbers::pi / 2.0;

}  // namespace

double potential(double d) {
  if (d >= 1.0) return 0.0;
  const double theta = half_pi * d;
  return 1.0 / std::tan(theta) + theta - half_pi;
}

double potential_derivative(double d) {
  if (d >= 1.0) return 0.0;
  const double cotangent = 1.0 / std::tan(half_pi * d);
  return -half_pi * cotangent * cotangent;
}

double potential_second_derivative(double d) {
  if (d >= 1.0) return 0.0;
  const double theta = half_pi * d;
  const double sine = std::sin(theta);
  return 2.0 * half_pi * half_pi * std::cos(theta) / (sine * sine * sine);
}

PotentialTable::PotentialTable() {
  for (std::size_t n = 0; n < entries_.size(); ++n) {
    const double d = std::min(1.0, lowest + static_cast<double>(n) / scale);
    const double derivative = potential_derivative(d);
    entries_[n] = {potential(d), derivative, 0.5 * std::max(0.0, potential_second_derivative(d) + derivative / d)};
  }
}

const PotentialTable& PotentialTable::instance() {
  static const PotentialTable table;
  return table;
}

}  // namespace isobench::particles
