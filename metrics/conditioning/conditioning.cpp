#include "isobench/metrics/conditioning/conditioning.h"

#include <cmath>

#include "isobench/metrics/finite_elements/eigenvalues.h"

namespace isobench {

namespace {

/// D^-½ for the diagonal D.
Eigen::VectorXd jacobi(const SparseMatrix& a) { return a.diagonal().cwiseSqrt().cwiseInverse(); }

}  // namespace

std::optional<double> condition(const FiniteElements& elements, Monitor& monitor) {
  constexpr double tolerance = 1e-7;
  constexpr int max_steps = 2000;
  SparseMatrix a = screened_stiffness(elements);
  a = scaled(a, jacobi(a));
  const auto factors = factorized(a);
  if (factors == nullptr) return std::nullopt;
  const auto times_a = [&a](const Eigen::VectorXd& x, Eigen::VectorXd& y) { multiply(a, x, y); };
  const auto over_a = [&factors](const Eigen::VectorXd& x, Eigen::VectorXd& y) { y = factors->solve(x); };
  const auto largest = largest_eigenvalue(a.rows(), times_a, nullptr, tolerance, max_steps, monitor);
  const auto inverse_of_smallest = largest_eigenvalue(a.rows(), over_a, nullptr, tolerance, max_steps, monitor);
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

std::optional<int> jacobi_steps(const FiniteElements& elements, Monitor& monitor) {
  const SparseMatrix a = screened_stiffness(elements);
  const Eigen::VectorXd scale = jacobi(a);
  const Eigen::VectorXd b = scale.cwiseProduct(random_vector(a.rows(), 1));
  return conjugate_gradient_steps(scaled(a, scale), b, 1e-8, 20000, monitor);
}

}  // namespace isobench
