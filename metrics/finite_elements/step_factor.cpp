#include "isobench/metrics/finite_elements/step_factor.h"

#include "isobench/metrics/finite_elements/eigenvalues.h"

namespace isobench {

std::optional<double> step_factor(const FiniteElements& elements, const Eigen::VectorXd& h, Monitor& monitor) {
  const SparseMatrix a = scaled(elements.stiffness, h.cwiseQuotient(elements.lumped_mass.cwiseSqrt()));
  const auto times_a = [&a](const Eigen::VectorXd& x, Eigen::VectorXd& y) { multiply(a, x, y); };
  return largest_eigenvalue(a.rows(), times_a, nullptr, 1e-7, 2000, monitor);
}

}  // namespace isobench
