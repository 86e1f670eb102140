// Two substances that react and spread on a surface. Nearly even concentrations become spots (Turing 1952); the
// reaction is that of Schnakenberg 1979:
//
//   ∂u/∂t = D Δu + 0.1 − u + u²v,   ∂v/∂t = 20 D Δv + 0.9 − u²v.
//
// Space: linear finite elements with lumped mass. Time, which has no unit: explicit Euler, u ← u + τ(…).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "isobench/foundation/monitor.h"
#include "isobench/metrics/finite_elements/finite_elements.h"

namespace isobench {

struct SpotPattern {
  double wavelength = 1.0;  ///< mm: of the wave that grows fastest; spots are about this far apart

  /// D: in an even mixture, waves of the eigenvalue 9/(38 D) of −Δ grow fastest.
  double diffusion() const;
  /// With a longer step, waves grow that should vanish: τ(20 D λmax + 16) = 2, where λmax is the mesh's largest
  /// eigenvalue of M⁻¹K (1/mm²), and 16 stands for the reaction: v vanishes with the rate u², and u stays below 4.
  double largest_step(double largest_eigenvalue) const;

  /// After this time all spots are there. (Waves grow by the factor e in the time 3.8.)
  static constexpr double duration = 24.0;
};

/// One column for each unknown: u and v.
using Concentrations = Eigen::Matrix2Xd;

/// Even concentrations, u = 1 and v = 0.9, with waves in u that depend on the place alone: two meshes of one surface
/// begin alike. `points`: mm, one for each unknown.
Concentrations first_concentrations(const std::vector<Eigen::Vector3d>& points, const SpotPattern& pattern);

/// A simulation, ended or stopped.
struct March {
  Concentrations concentrations;
  std::size_t steps = 0;
  bool blew_up = false;
  Eigen::Index worst = 0;  ///< where the largest concentration is, if it blew up
};

/// Does `steps` steps, or stops as soon as a concentration is above 100: spots reach 4. All threads, with the same bits
/// for any number of them. Cost: a pass over the rows of K a step, some 10 ns a row on two cores. Precondition: the
/// elements are regular. Throws Cancelled.
March march(const FiniteElements& elements, const SpotPattern& pattern, Concentrations first, double step,
            std::size_t steps, Monitor& monitor);

}  // namespace isobench
