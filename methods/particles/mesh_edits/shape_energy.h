// The shape energy of a vertex: how far the triangles around it are from equilateral and from the areas asked for.
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
  std::array<double, most + 1> areas;             ///< mm²: asked of triangles at the neighbours (asked_areas.h)
  double area = 1.0;                              ///< mm²: asked of triangles at the vertex itself
  std::size_t size = 0;                           ///< number of triangles
};

/// Σ r^p + w (a^q + a^−q) over triangles with area A and edges l: r = Σ l²/(4√3 A), which is 1 for an equilateral
/// triangle and larger otherwise, and a = A over the mean of the areas asked at the corners. The terms of a are
/// constant beyond a range: moves cannot make triangles even there, and would only spoil shapes. Equal areas bound the
/// largest eigenvalue of the Laplacian, and so the steps of explicit time integration. Large exponents act on the worst
/// triangles and leave the others free: with p = 8 and q = 1, the same smallest areas cost 0.003 more of the mean Q.
struct ShapeEnergy {
  int shape_doublings = 5;   ///< p = 2 to this power
  int area_doublings = 4;    ///< q = 2 to this power
  double area_weight = 0.0;  ///< w; 0: shapes alone
  double range = 1e300;      ///< the terms of a change between 1/range and range
};

/// The energy with the vertex at x, and its gradient and Hessian with respect to moves in the plane of two unit
/// tangents.
struct EnergyJet {
  double value = 0.0;
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
  Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
};
EnergyJet shape_energy(const ShapeEnergy& energy, const Ring& ring, const Eigen::Vector3d& x,
                       const Eigen::Vector3d& tangent_u, const Eigen::Vector3d& tangent_v);

/// The energy without derivatives, and the tilt of the triangles.
struct FanState {
  double energy = 0.0;
  double least_cosine = 1.0;  ///< cosine of the largest angle between a triangle and the normal at one of its corners
};
FanState fan_state(const ShapeEnergy& energy, const Ring& ring, const Eigen::Vector3d& x,
                   const Eigen::Vector3d& normal);

/// The Newton step, with the Hessian made positive definite.
Eigen::Vector2d newton_step(const EnergyJet& jet);

}  // namespace isobench::particles
