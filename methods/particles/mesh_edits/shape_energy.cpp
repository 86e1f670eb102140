#include "isobench/methods/particles/mesh_edits/shape_energy.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace isobench::particles {

namespace {

// The area is taken to be at least this share of Σ l², so that the energy stays finite.
constexpr double least_area = 5e-5;

/// x to the power of two that has `doublings` factors of two.
double raise(double x, int doublings) {
  for (int k = 0; k < doublings; ++k) x *= x;
  return x;
}

/// A triangle between the vertex at x and two of its neighbours, b and c.
struct Corner {
  Eigen::Vector3d to_b;
  Eigen::Vector3d to_c;
  Eigen::Vector3d edge;     // from b to c
  Eigen::Vector3d cross;    // to_b × to_c
  double squares = 0.0;     // Σ l²
  double length = 0.0;      // |cross|
  double twice_area = 0.0;  // |cross|, but not less than the least area
  double r = 0.0;
  double a = 0.0;

  Corner(const Ring& ring, std::size_t k, const Eigen::Vector3d& x)
      : to_b(ring.points[k] - x), to_c(ring.points[k + 1] - x), edge(to_c - to_b), cross(to_b.cross(to_c)) {
    squares = to_b.squaredNorm() + to_c.squaredNorm() + edge.squaredNorm();
    length = cross.norm();
    twice_area = std::max({length, 2.0 * least_area * squares, 1e-300});
    r = squares / (2.0 * std::numbers::sqrt3 * twice_area);
    a = twice_area * 1.5 / (ring.area + ring.areas[k] + ring.areas[k + 1]);
  }
};

/// r^p, and the two terms of the area, each with its weight.
struct Terms {
  double shape = 0.0;
  double large = 0.0;
  double small = 0.0;
  bool areas_act = false;  // whether a is in the range where its terms change

  Terms(const ShapeEnergy& energy, const Corner& corner) : shape(raise(corner.r, energy.shape_doublings)) {
    if (!(energy.area_weight > 0.0)) return;
    const double a = std::clamp(corner.a, 1.0 / energy.range, energy.range);
    const double power = raise(a, energy.area_doublings);
    large = energy.area_weight * power;
    small = energy.area_weight / std::max(power, 1e-200);
    areas_act = a == corner.a;
  }
  double sum() const { return shape + large + small; }
};

}  // namespace

double radius_ratio(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double la = (b - c).norm();
  const double lb = (c - a).norm();
  const double lc = (a - b).norm();
  const double product = (la + lb + lc) * la * lb * lc;
  return product > 0.0 ? 4.0 * (b - a).cross(c - a).squaredNorm() / product : 0.0;
}

EnergyJet shape_energy(const ShapeEnergy& energy, const Ring& ring, const Eigen::Vector3d& x,
                       const Eigen::Vector3d& tangent_u, const Eigen::Vector3d& tangent_v) {
  const double p = static_cast<double>(1 << energy.shape_doublings);
  const double q = static_cast<double>(1 << energy.area_doublings);
  EnergyJet jet;
  const auto in_plane = [&](const Eigen::Vector3d& v) { return Eigen::Vector2d(v.dot(tangent_u), v.dot(tangent_v)); };
  for (std::size_t k = 0; k < ring.size; ++k) {
    const Corner corner(ring, k, x);
    const Terms terms(energy, corner);
    const Eigen::Vector3d normal = corner.cross / corner.twice_area;
    // Derivatives of ln Σ l² and of ln A. Out of the triangle's plane, A has a second derivative as well.
    const Eigen::Vector2d of_squares = in_plane(corner.to_b + corner.to_c) * (-2.0 / corner.squares);
    const Eigen::Vector2d of_area = in_plane(normal.cross(corner.edge)) / corner.twice_area;
    const Eigen::Vector2d out = in_plane(normal) * (corner.edge.norm() / corner.twice_area);
    const Eigen::Matrix2d squares_second =
        Eigen::Matrix2d::Identity() * (4.0 / corner.squares) - of_squares * of_squares.transpose();
    const Eigen::Matrix2d area_first = of_area * of_area.transpose();
    const Eigen::Matrix2d area_second = out * out.transpose() - area_first;
    const Eigen::Vector2d of_r = of_squares - of_area;
    const double balance = terms.areas_act ? q * (terms.large - terms.small) : 0.0;
    const double stiffness = terms.areas_act ? q * q * (terms.large + terms.small) : 0.0;
    jet.value += terms.sum();
    jet.gradient += p * terms.shape * of_r + balance * of_area;
    jet.hessian += p * terms.shape * (p * of_r * of_r.transpose() + squares_second - area_second) +
                   stiffness * area_first + balance * area_second;
  }
  return jet;
}

FanState fan_state(const ShapeEnergy& energy, const Ring& ring, const Eigen::Vector3d& x,
                   const Eigen::Vector3d& normal) {
  FanState state;
  for (std::size_t k = 0; k < ring.size; ++k) {
    const Corner corner(ring, k, x);
    state.energy += Terms(energy, corner).sum();
    const double turned =
        std::min({corner.cross.dot(normal), corner.cross.dot(ring.normals[k]), corner.cross.dot(ring.normals[k + 1])});
    state.least_cosine = std::min(state.least_cosine, corner.length > 0.0 ? turned / corner.length : -1.0);
  }
  return state;
}

Eigen::Vector2d newton_step(const EnergyJet& jet) {
  const Eigen::Matrix2d& h = jet.hessian;
  const double mean = 0.5 * (h(0, 0) + h(1, 1));
  const double half = 0.5 * (h(0, 0) - h(1, 1));
  const double radius = std::hypot(half, h(0, 1));
  const double high = std::max({mean + radius, radius - mean, 1e-300});
  // The magnitude of a negative eigenvalue still gives the length of the step.
  const double low = std::max(std::abs(mean - radius), 0.1 * high);
  // The inverse of the matrix with the eigenvectors of H and the eigenvalues high and low.
  if (radius < 1e-12 * high) return -jet.gradient / high;
  Eigen::Matrix2d direction = (h - mean * Eigen::Matrix2d::Identity()) / radius;
  const double inverse_mean = 0.5 * (1.0 / high + 1.0 / low);
  const double inverse_half = 0.5 * (1.0 / high - 1.0 / low);
  return -(inverse_mean * jet.gradient + inverse_half * (direction * jet.gradient));
}

}  // namespace isobench::particles
