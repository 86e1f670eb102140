// Surfaces whose derivatives are known in closed form, for tests.
#pragma once

#include <cmath>
#include <vector>

#include "isobench/metrics/foot_points/foot_points.h"

namespace isobench::known_surfaces {

/// f = 1 − (x/a)² − (y/b)² − (z/c)².
inline Jet ellipsoid(const Eigen::Vector3d& axes, const Eigen::Vector3d& x) {
  const Eigen::Array3d scales = axes.array().square().inverse();
  return {1.0 - (scales * x.array().square()).sum(), -2.0 * (scales * x.array()).matrix(),
          -2.0 * scales.matrix().asDiagonal().toDenseMatrix()};
}

/// The torus of sample_meshes::torus(): f = 1 − (ρ − 2)² − z² with ρ² = x² + y².
inline Jet torus(const Eigen::Vector3d& x) {
  const double rho = std::hypot(x.x(), x.y());
  const Eigen::Vector3d outwards(x.x() / rho, x.y() / rho, 0.0);
  const Eigen::Vector3d around(-outwards.y(), outwards.x(), 0.0);
  const Eigen::Vector3d up(0.0, 0.0, 1.0);
  const double beyond = rho - 2.0;
  return {1.0 - beyond * beyond - x.z() * x.z(), -2.0 * (beyond * outwards + x.z() * up),
          -2.0 * (outwards * outwards.transpose() + beyond / rho * around * around.transpose() + up * up.transpose())};
}

/// Foot points by Newton's steps along the gradient, to the last digits.
template <class JetAt>
std::vector<FootPoint> feet(const std::vector<Eigen::Vector3d>& points, JetAt jet) {
  std::vector<FootPoint> result;
  for (Eigen::Vector3d x : points) {
    for (int step = 0; step < 10; ++step) {
      const Jet at = jet(x);
      x -= at.value / at.gradient.squaredNorm() * at.gradient;
    }
    result.push_back({x, jet(x), true});
  }
  return result;
}

}  // namespace isobench::known_surfaces
