// How badly shaped the triangles around a vertex are: Σ 1/Q^p over them, with derivatives.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace isobench::particles {

/// Q = 2 r/R of a triangle, r inscribed and R circumscribed: 1 equilateral, 0 without area.
double radius_ratio(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// The neighbours of a vertex in order; the first stands again at the end.
struct Ring {
  static constexpr std::size_t most = 40;
  std::array<Eigen::Vector3d, most + 1> points;
  std::array<Eigen::Vector3d, most + 1> normals;  ///< of F there
  std::size_t size = 0;                           ///< triangles
};

/// p = 3·2^doublings.
struct ShapeEnergy {
  int doublings = 0;
};

/// Σ 1/Q^p with the apex at x, its gradient and Hessian with respect to a move in the plane of the unit tangents.
struct EnergyJet {
  double value = 0.0;
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
  Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
};
EnergyJet shape_energy(ShapeEnergy energy, const Ring& ring, const Eigen::Vector3d& x, const Eigen::Vector3d& tangent_u,
                       const Eigen::Vector3d& tangent_v);

/// The value alone, and how far the triangle turned most is from its corners' normals.
struct FanState {
  double energy = 0.0;
  double least_cosine = 1.0;  ///< of the angles between triangles and the normals at their corners
};
FanState fan_state(ShapeEnergy energy, const Ring& ring, const Eigen::Vector3d& x, const Eigen::Vector3d& normal);

/// The step that Newton's method takes from there, with the Hessian made positive.
Eigen::Vector2d newton_step(const EnergyJet& jet);

}  // namespace isobench::particles
