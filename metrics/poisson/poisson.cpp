#include "isobench/metrics/poisson/poisson.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace isobench {

namespace {

// Oblique, so that no plane of symmetry of a phantom is one of the solution.
const Eigen::Vector3d direction_a = Eigen::Vector3d(2.0, 3.0, 6.0) / 7.0;
const Eigen::Vector3d direction_b = Eigen::Vector3d(3.0, -6.0, 2.0) / 7.0;

/// The gradient of the linear function with these values at the corners.
Eigen::Vector3d linear_gradient(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                                const Eigen::Vector3d& values) {
  const Eigen::Vector3d twice = (b - a).cross(c - a);
  const Eigen::Vector3d rotated = values[0] * (c - b) + values[1] * (a - c) + values[2] * (b - a);
  return twice.cross(rotated) / twice.squaredNorm();
}

}  // namespace

double ManufacturedSolution::value(const Eigen::Vector3d& x) const {
  return std::sin(wave_ * direction_a.dot(x)) + std::cos(wave_ * direction_b.dot(x));
}

Eigen::Vector3d ManufacturedSolution::gradient(const Eigen::Vector3d& x) const {
  return wave_ *
         (std::cos(wave_ * direction_a.dot(x)) * direction_a - std::sin(wave_ * direction_b.dot(x)) * direction_b);
}

Eigen::Matrix3d ManufacturedSolution::hessian(const Eigen::Vector3d& x) const {
  return -wave_ * wave_ *
         (std::sin(wave_ * direction_a.dot(x)) * direction_a * direction_a.transpose() +
          std::cos(wave_ * direction_b.dot(x)) * direction_b * direction_b.transpose());
}

Eigen::Vector3d ManufacturedSolution::surface_gradient(const FootPoint& foot) const {
  const Eigen::Vector3d g = gradient(foot.x);
  return g - g.dot(foot.normal()) * foot.normal();
}

double ManufacturedSolution::surface_laplacian(const FootPoint& foot) const {
  const Eigen::Vector3d n = foot.normal();
  const Eigen::Matrix3d second = hessian(foot.x);
  return second.trace() - n.dot(second * n) - 2.0 * foot.mean_curvature() * n.dot(gradient(foot.x));
}

std::optional<PoissonErrors> poisson_errors(const FiniteElements& elements, const ScreenedSystem& system,
                                            const std::vector<FootPoint>& feet) {
  const ManufacturedSolution solution(std::sqrt(elements.squared_radius()));
  Eigen::VectorXd u(elements.size());
  Eigen::VectorXd f(elements.size());
  for (Eigen::Index i = 0; i < elements.size(); ++i) {
    const FootPoint& foot = feet[elements.vertex[static_cast<std::size_t>(i)]];
    u[i] = solution.value(foot.x);
    f[i] = u[i] / elements.squared_radius() - solution.surface_laplacian(foot);
  }
  if (!f.allFinite() || system.factors == nullptr) return std::nullopt;
  const Eigen::VectorXd error = system.solve(elements.mass * f) - u;
  const double squares = u.dot(elements.lumped_mass.cwiseProduct(u));
  const double rms = std::sqrt(squares / elements.area);
  return PoissonErrors{error.cwiseAbs().maxCoeff() / rms,
                       std::sqrt(error.dot(elements.lumped_mass.cwiseProduct(error)) / squares),
                       error.cwiseAbs() / rms};
}

std::optional<GradientErrors> gradient_errors(const FiniteElements& elements, const TriangleMesh& mesh,
                                              const std::vector<FootPoint>& feet,
                                              const std::vector<FootPoint>& centroid_feet) {
  const ManufacturedSolution solution(std::sqrt(elements.squared_radius()));
  const auto& x = mesh.vertices;
  double area = 0.0;
  double squares = 0.0;
  GradientErrors errors;
  errors.of_triangles.assign(mesh.triangles.size(), 0.0);
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    const Triangle& t = mesh.triangles[n];
    if (is_collapsed(t) || !centroid_feet[n].exists) continue;
    const Eigen::Vector3d values(solution.value(feet[t[0]].x), solution.value(feet[t[1]].x),
                                 solution.value(feet[t[2]].x));
    const Eigen::Vector3d exact = solution.surface_gradient(centroid_feet[n]);
    const double twice_area = (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).norm();
    area += twice_area;
    squares += twice_area * exact.squaredNorm();
    errors.of_triangles[n] = (linear_gradient(x[t[0]], x[t[1]], x[t[2]], values) - exact).norm();
    errors.max = std::max(errors.max, errors.of_triangles[n]);
  }
  if (!(squares > 0.0)) return std::nullopt;
  const double rms = std::sqrt(squares / area);
  errors.max /= rms;
  for (double& error : errors.of_triangles) error /= rms;
  return errors;
}

}  // namespace isobench
