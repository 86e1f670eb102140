// The linear systems of u/L² − Δu = f, which is what a mesh's conditioning and its errors are measured by.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "isobench/metrics/finite_elements/finite_elements.h"
#include "isobench/metrics/finite_elements/sparse_matrix.h"

namespace isobench {

/// (K + M/L²) x = b, with Jacobi's preconditioner on both sides. K + M/L² is K with a term that makes the solution
/// unique, on every component of any mesh.
struct ScreenedSystem {
  Eigen::VectorXd scale;                   ///< D^-½, with the diagonal D of K + M/L². One number an unknown
  SparseMatrix matrix;                     ///< Â = D^-½ (K + M/L²) D^-½
  std::unique_ptr<Factorization> factors;  ///< of Â; nullptr where it is not positive definite to the last digit

  /// (K + M/L²)⁻¹ b. Precondition: there are factors.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
};

/// The cost is that of factorized(). Precondition: the elements are regular.
ScreenedSystem screened_system(const FiniteElements& elements);

}  // namespace isobench
