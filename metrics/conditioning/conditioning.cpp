#include "isobench/metrics/conditioning/conditioning.h"

#include <cmath>

#include "isobench/metrics/finite_elements/eigenvalues.h"

namespace isobench {

std::optional<double> condition(const FiniteElements& elements, const ScreenedSystem& system, Monitor& monitor) {
  constexpr double tolerance = 1e-7;
  constexpr int max_steps = 2000;
  if (system.factors == nullptr) return std::nullopt;
  const auto times = [&system](const Eigen::VectorXd& x, Eigen::VectorXd& y) { multiply(system.matrix, x, y); };
  const auto over = [&system](const Eigen::VectorXd& x, Eigen::VectorXd& y) { y = system.factors->solve(x); };
  const auto largest = largest_eigenvalue(elements.size(), times, nullptr, tolerance, max_steps, monitor);
  const auto inverse_of_smallest = largest_eigenvalue(elements.size(), over, nullptr, tolerance, max_steps, monitor);
  if (!largest || !inverse_of_smallest) return std::nullopt;
  return *largest * *inverse_of_smallest * elements.mean_squared_edge() / elements.squared_radius();
}

std::optional<int> conjugate_gradient_steps(const SparseMatrix& a, const Eigen::VectorXd& b, double tolerance,
                                            int max_steps, Monitor& monitor) {
  Eigen::VectorXd residual = b;
  Eigen::VectorXd direction = b;
  Eigen::VectorXd product;
  double square = ordered_dot(b, b);
  const double enough = tolerance * tolerance * square;
  for (int steps = 0; steps <= max_steps; ++steps) {
    monitor.check();
    if (square <= enough) return steps;
    const double curvature = multiply(a, direction, product);
    if (!(curvature > 0.0) || !std::isfinite(square)) return std::nullopt;
    const double length = square / curvature;
    const double next = ordered_sum(b.size(), [&](Eigen::Index first, Eigen::Index count) {
      residual.segment(first, count) -= length * product.segment(first, count);
      return residual.segment(first, count).squaredNorm();
    });
    // The solution itself is not needed.
    ordered_sum(b.size(), [&](Eigen::Index first, Eigen::Index count) {
      direction.segment(first, count) =
          residual.segment(first, count) + next / square * direction.segment(first, count);
      return 0.0;
    });
    square = next;
  }
  return std::nullopt;
}

std::optional<int> jacobi_steps(const ScreenedSystem& system, Monitor& monitor) {
  const Eigen::VectorXd b = system.scale.cwiseProduct(random_vector(system.scale.size(), 1));
  return conjugate_gradient_steps(system.matrix, b, 1e-8, 20000, monitor);
}

}  // namespace isobench
