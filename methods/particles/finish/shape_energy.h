// The shape energy of a vertex: Σ 1/Q^p over the triangles around it, and its derivatives.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace isobench::particles {

/// Q = 2 r/R of a triangle with inradius r and circumradius R: 1 for an equilateral triangle, 0 without area.
double radius_ratio(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// The neighbours of a vertex in order; the first one is repeated at the end.
struct Ring {
  static constexpr std::size_t most = 40;
  std::array<Eigen::Vector3d, most + 1> points;
  std::array<Eigen::Vector3d, most + 1> normals;  ///< of F at the neighbours
  std::size_t size = 0;                           ///< number of triangles
};

/// The exponent: p = 3 · 2^doublings.
struct ShapeEnergy {
  int doublings = 0;
};

/// Σ 1/Q^p with the vertex at x, and its gradient and Hessian with respect to moves in the plane of two unit tangents.
struct EnergyJet {
  double value = 0.0;
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
  Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
};
EnergyJet shape_energy(ShapeEnergy energy, const Ring& ring, const Eigen::Vector3d& x, const Eigen::Vector3d& tangent_u,
                       const Eigen::Vector3d& tangent_v);

/// The energy without derivatives, and the tilt of the triangles.
struct FanState {
  double energy = 0.0;
  double least_cosine = 1.0;  ///< cosine of the largest angle between a triangle and the normal at one of its corners
};
FanState fan_state(ShapeEnergy energy, const Ring& ring, const Eigen::Vector3d& x, const Eigen::Vector3d& normal);

/// The Newton step, with the Hessian made positive definite.
Eigen::Vector2d newton_step(const EnergyJet& jet);

}  // namespace isobench::particles
