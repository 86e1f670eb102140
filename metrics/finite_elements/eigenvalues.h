// Extreme eigenvalues of large symmetric matrices by the method of Lanczos (Golub and Van Loan, Matrix Computations,
// chapter 10), without reorthogonalisation: rounding brings copies of eigenvalues that have converged, which does the
// extreme ones no harm (Paige 1976).
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "isobench/foundation/monitor.h"

namespace isobench {

/// The symmetric tridiagonal matrix that k steps of Lanczos make of a large one. Its eigenvalues, the Ritz values,
/// approximate those of the large matrix.
struct Tridiagonal {
  std::vector<double> diagonal;  ///< k numbers
  std::vector<double> beside;    ///< k numbers > 0; the last one leads to the next step

  /// The largest eigenvalue, to the last digits. Linear time in k. Precondition: at least one step.
  double largest() const;
  /// There is an eigenvalue of the large matrix within this distance of a Ritz value. Only until it has converged: a
  /// copy that rounding brings has a large bound again.
  double error_of(double ritz_value) const;
};

using LinearMap = std::function<void(const Eigen::VectorXd& x, Eigen::VectorXd& y)>;

/// The largest λ with A x = λ B x, A symmetric and B symmetric and positive definite, as soon as the bound on its error
/// is below `tolerance` relative to it. `times_a` is y = A x, `over_b` is y = B⁻¹ x; without it, B is the identity.
/// std::nullopt if that takes more than `max_steps` steps, or numbers get out of range. Each step calls both once.
std::optional<double> largest_eigenvalue(Eigen::Index size, const LinearMap& times_a, const LinearMap& over_b,
                                         double tolerance, int max_steps, Monitor& monitor);

}  // namespace isobench
