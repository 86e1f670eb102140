#include "isobench/methods/particles/finish/shape_energy.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace isobench::particles {

namespace {

constexpr double floor_q = 1e-4;  // Q is taken to be at least this, so that the energy stays finite

/// (1/Q)^p.
double raise(ShapeEnergy energy, double inverse_q) {
  double f = inverse_q * inverse_q * inverse_q;
  for (int k = 0; k < energy.doublings; ++k) f *= f;
  return f;
}

}  // namespace

double radius_ratio(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double la = (b - c).norm();
  const double lb = (c - a).norm();
  const double lc = (a - b).norm();
  const double product = (la + lb + lc) * la * lb * lc;
  return product > 0.0 ? 4.0 * (b - a).cross(c - a).squaredNorm() / product : 0.0;
}

EnergyJet shape_energy(ShapeEnergy energy, const Ring& ring, const Eigen::Vector3d& x, const Eigen::Vector3d& tangent_u,
                       const Eigen::Vector3d& tangent_v) {
  const double p = 3.0 * static_cast<double>(1 << energy.doublings);
  EnergyJet jet;
  // An edge from x: its length, and the gradient and Hessian of the length in the tangent plane.
  struct Edge {
    double length;
    Eigen::Vector2d first;
    Eigen::Matrix2d second;
  };
  std::array<Edge, Ring::most + 1> edges;
  for (std::size_t k = 0; k < ring.size; ++k) {
    const Eigen::Vector3d apart = x - ring.points[k];
    const double length = std::max(apart.norm(), 1e-300);
    const Eigen::Vector2d e(apart.dot(tangent_u) / length, apart.dot(tangent_v) / length);
    edges[k] = {length, e, (Eigen::Matrix2d::Identity() - e * e.transpose()) / length};
  }
  edges[ring.size] = edges[0];
  for (std::size_t k = 0; k < ring.size; ++k) {
    const double a = (ring.points[k + 1] - ring.points[k]).norm();
    const double b = edges[k].length;
    const double c = edges[k + 1].length;
    // Q = (b+c−a)(c+a−b)(a+b−c)/(abc); s, t and u are the inverses of the three factors.
    const double tiny = floor_q * (a + b + c);
    const double s = 1.0 / std::max(b + c - a, tiny);
    const double t = 1.0 / std::max(c + a - b, tiny);
    const double u = 1.0 / std::max(a + b - c, tiny);
    const double f = raise(energy, a * b * c * s * t * u);
    const double db = s - t + u - 1.0 / b;
    const double dc = s + t - u - 1.0 / c;
    const double dbb = -s * s - t * t - u * u + 1.0 / (b * b);
    const double dcc = -s * s - t * t - u * u + 1.0 / (c * c);
    const double dbc = -s * s + t * t + u * u;
    // f = exp(−p ln Q), and ln Q depends on x through b and c.
    const Eigen::Vector2d& eb = edges[k].first;
    const Eigen::Vector2d& ec = edges[k + 1].first;
    const Eigen::Vector2d log_first = db * eb + dc * ec;
    const Eigen::Matrix2d mixed = eb * ec.transpose();
    const Eigen::Matrix2d log_second = dbb * eb * eb.transpose() + dcc * ec * ec.transpose() +
                                       dbc * (mixed + mixed.transpose()) + db * edges[k].second +
                                       dc * edges[k + 1].second;
    jet.value += f;
    jet.gradient -= p * f * log_first;
    jet.hessian += p * f * (p * log_first * log_first.transpose() - log_second);
  }
  return jet;
}

FanState fan_state(ShapeEnergy energy, const Ring& ring, const Eigen::Vector3d& x, const Eigen::Vector3d& normal) {
  FanState state;
  Eigen::Vector3d to_b = ring.points[0] - x;
  double b = to_b.norm();
  for (std::size_t k = 0; k < ring.size; ++k) {
    const Eigen::Vector3d to_c = ring.points[k + 1] - x;
    const double c = to_c.norm();
    const double a = (ring.points[k + 1] - ring.points[k]).norm();
    const Eigen::Vector3d across = to_b.cross(to_c);
    const double square = across.squaredNorm();
    const double inverse_q = (a + b + c) * a * b * c / std::max(4.0 * square, 1e-300);
    state.energy += raise(energy, std::min(inverse_q, 1.0 / floor_q));
    const double turned = std::min({across.dot(normal), across.dot(ring.normals[k]), across.dot(ring.normals[k + 1])});
    state.least_cosine = std::min(state.least_cosine, square > 0.0 ? turned / std::sqrt(square) : -1.0);
    to_b = to_c;
    b = c;
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
