// The potential between two particles at the normalised distance d = β|x_i − x_j|/min(h_i, h_j), β = 0.5/cos(π/6)
// (Meyer, Kirby, Whitaker 2007, equations 4 and 5; Meyer, Nelson, Kirby, Whitaker 2007 for the potential):
// E = cot θ + θ − π/2, θ = πd/2, for d < 1, else 0. In a hexagonal packing of spacing h neighbours are at d = β and the
// second ring at d = 1, so six neighbours act.
#pragma once

#include <array>
#include <cstddef>

namespace isobench::particles {

constexpr double beta = 0.57735026918962576451;  // 1/√3
/// 6 E(β): the energy of a particle in the ideal packing.
constexpr double ideal_energy = 0.710825908192;

double pair_energy(double d);
double pair_energy_first(double d);   ///< E′ = −(π/2) cot²θ
double pair_energy_second(double d);  ///< E″ = (π²/2) cos θ/sin³θ

/// E, E′ and the curvature ½ max(0, E″ + E′/d) of a step, tabulated over d; linear between entries. Below d = 0.05,
/// where they grow without bound, the table ends.
class PotentialTable {
 public:
  struct Entry {
    double energy;
    double first;
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
    return {a.energy + t * (b.energy - a.energy), a.first + t * (b.first - a.first),
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
