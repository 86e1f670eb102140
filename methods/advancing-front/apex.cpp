#include "isobench/methods/advancing-front/apex.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace isobench::advancing_front {

namespace {

/// The circle of points with the given distances from a and b: foot + height (cos φ · level + sin φ · up).
struct Circle {
  Eigen::Vector3d foot;
  Eigen::Vector3d level;
  Eigen::Vector3d up;
  double height;

  Circle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& normal, const Sides& sides) {
    const double edge = (b - a).norm();
    const Eigen::Vector3d along = (b - a) / edge;
    const double t =
        0.5 * (edge * edge + sides.from_a * sides.from_a - sides.from_b * sides.from_b) / edge;  // law of cosines
    foot = a + t * along;
    height = std::sqrt(std::max(0.0, sides.from_a * sides.from_a - t * t));
    level = normal.cross(along).normalized();
    up = along.cross(level);
  }
  Eigen::Vector3d at(double angle) const { return foot + height * (std::cos(angle) * level + std::sin(angle) * up); }
};

bool in_lattice(const Isosurface& surface, const Eigen::Vector3d& x) {
  return (x.array() >= 0.0).all() && (x.array() <= surface.extent().array()).all();
}

/// The angle between the sides p and q of a triangle whose third side is r.
double angle_between(double p, double q, double r) {
  return std::acos(std::clamp((p * p + q * q - r * r) / (2.0 * p * q), -1.0, 1.0));
}

/// The angle that a triangle takes of a gap: its `own` one, or an equal share if the gap has room for only one or two
/// triangles.
double share_of(double gap, double own) {
  constexpr double sixty = std::numbers::pi / 3.0;
  if (gap > 2.5 * sixty) return own;
  return std::clamp(gap / std::max(1.0, std::round(gap / sixty)), 0.8 * sixty, 1.2 * sixty);
}

/// Sides whose angles share the gaps at both ends: each end proposes a position of the apex, and their mean is taken.
Sides shared_out(double edge, const Sides& sides, const GapAngles& gaps) {
  const double at_a = share_of(gaps.at_a, angle_between(edge, sides.from_a, sides.from_b));
  const double at_b = share_of(gaps.at_b, angle_between(edge, sides.from_b, sides.from_a));
  const double x = 0.5 * (sides.from_a * std::cos(at_a) + edge - sides.from_b * std::cos(at_b));
  const double y = 0.5 * (sides.from_a * std::sin(at_a) + sides.from_b * std::sin(at_b));
  return {std::hypot(x, y), std::hypot(edge - x, y)};
}

}  // namespace

Sides feasible_sides(double edge, const Sides& wanted) {
  Sides sides = wanted;
  // The foot of the apex lies between a and b if the squares of the sides differ by less than the square of the edge.
  const double square_gap = sides.from_a * sides.from_a - sides.from_b * sides.from_b;
  if (std::abs(square_gap) > 0.8 * edge * edge) {
    const double mean = 0.5 * (sides.from_a + sides.from_b);
    sides = {mean, mean};
  }
  const double stretch = 1.15 * edge / (sides.from_a + sides.from_b);  // equal sides then have 30° at both ends
  if (stretch > 1.0) sides = {stretch * sides.from_a, stretch * sides.from_b};
  return sides;
}

Eigen::Vector3d planar_apex(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& normal,
                            const Sides& sides) {
  return Circle(a, b, normal, sides).at(0.0);
}

std::optional<Eigen::Vector3d> rotate_to_surface(const Isosurface& surface, const Eigen::Vector3d& a,
                                                 const Eigen::Vector3d& b, const Eigen::Vector3d& normal,
                                                 const Sides& sides) {
  const Circle circle(a, b, normal, sides);
  constexpr double bracket = std::numbers::pi / 60.0;
  const double start = surface.value(circle.at(0.0));
  const double sign = start > 0.0 ? 1.0 : -1.0;  // where f > 0, the point is inside and the surface above it
  double low = 0.0, f_low = start;
  for (int n = 1; n <= 30; ++n) {
    const double high = n * bracket;
    const double f_high = surface.value(circle.at(sign * high));
    if ((f_high > 0.0) == (start > 0.0)) {
      low = high;
      f_low = f_high;
      continue;
    }
    std::uintmax_t steps = 40;
    const auto [left, right] =
        boost::math::tools::toms748_solve([&](double angle) { return surface.value(circle.at(sign * angle)); }, low,
                                          high, f_low, f_high, [](double l, double r) { return r - l < 1e-10; }, steps);
    const Eigen::Vector3d x = circle.at(sign * 0.5 * (left + right));
    return in_lattice(surface, x) ? std::optional(x) : std::nullopt;
  }
  return std::nullopt;
}

Vertex make_vertex(const Isosurface& surface, const Step& step, const Eigen::Vector3d& x) {
  return {x, outward_normal(surface.value_gradient(x).gradient), step(x)};
}

std::optional<Vertex> grown_apex(const Isosurface& surface, const Step& step, const Vertex& a, const Vertex& b,
                                 double shrink, const GapAngles& gaps) {
  const Eigen::Vector3d normal = a.normal + b.normal;
  const double edge = (b.x - a.x).norm();
  const Sides at_ends = feasible_sides(edge, {shrink * a.step, shrink * b.step});
  const double beyond = step(planar_apex(a.x, b.x, normal, at_ends));
  const Sides sides = feasible_sides(edge, {0.5 * shrink * (a.step + beyond), 0.5 * shrink * (b.step + beyond)});
  const auto x = rotate_to_surface(surface, a.x, b.x, normal, shared_out(edge, sides, gaps));
  if (!x) return std::nullopt;
  return make_vertex(surface, step, *x);
}

}  // namespace isobench::advancing_front
