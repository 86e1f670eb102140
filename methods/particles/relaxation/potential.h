// The potential energy E between two particles at the normalised distance d = β|x_i − x_j|/min(h_i, h_j), with
// β = 0.5/cos(π/6) (Meyer, Kirby, Whitaker 2007, equations 4 and 5):
//
//   E(d) = cot θ + θ − π/2 with θ = πd/2 for d < 1, and E(d) = 0 for d ≥ 1.
//
// In a hexagonal packing of spacing h, a particle's six neighbours are at d = β and the next ring is at d = 1, so only
// the six act on it.
#pragma once

#include <array>
#include <cstddef>

namespace isobench::particles {

constexpr double beta = 0.57735026918962576451;  // 1/√3
/// The energy of a particle in the ideal, hexagonal packing: 6 E(β).
constexpr double ideal_energy = 0.710825908192;

double potential(double d);                    ///< E
double potential_derivative(double d);         ///< E′ = −(π/2) cot²θ
double potential_second_derivative(double d);  ///< E″ = (π²/2) cos θ/sin³θ

/// E, E′ and the stiffness ½ max(0, E″ + E′/d) of a Newton step, tabulated over d and linear between entries. E and E′
/// grow without bound as d → 0, so the table begins at d = 0.05; below, its first entry holds.
class PotentialTable {
 public:
  struct Entry {
    double energy;
    double derivative;
    double stiffness;
  };
  static const PotentialTable& instance();
  /// d ∈ [0, 1).
  Entry at(double d) const {
    const double u = d < lowest ? 0.0 : (d - lowest) * scale;
    const auto n = static_cast<std::size_t>(u);
    const double t = u - static_cast<double>(n);
    const Entry& a = entries_[n];
    const Entry& b = entries_[n + 1];
    return {a.energy + t * (b.energy - a.energy), a.derivative + t * (b.derivative - a.derivative),
            a.stiffness + t * (b.stiffness - a.stiffness)};
  }

 private:
  static constexpr std::size_t size = 2048;
  static constexpr double lowest = 0.05;
  static constexpr double scale = static_cast<double>(size) / (1.0 - lowest);
  PotentialTable();
  std::array<Entry, size + 2> entries_{};
};

}  // namespace isobench::particles
