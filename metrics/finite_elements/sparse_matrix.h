// Products of large sparse matrices and vectors on all threads, with the same bits for any number of threads, and the
// solution of linear systems.
#pragma once

#include <tbb/parallel_for.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

namespace isobench {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, std::int32_t>;

/// The sum of of_block(first, length) over blocks of the numbers below `size`, added up in their order.
template <class OfBlock>
double ordered_sum(Eigen::Index size, OfBlock of_block) {
  constexpr Eigen::Index block = 4096;
  std::vector<double> sums(static_cast<std::size_t>((size + block - 1) / block));
  tbb::parallel_for(std::size_t{0}, sums.size(), [&](std::size_t n) {
    const Eigen::Index first = static_cast<Eigen::Index>(n) * block;
    sums[n] = of_block(first, std::min(block, size - first));
  });
  double sum = 0.0;
  for (const double part : sums) sum += part;
  return sum;
}

double ordered_dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

/// y = A x; returns x·y. Precondition: A is square, and x and y are two vectors.
double multiply(const SparseMatrix& a, const Eigen::VectorXd& x, Eigen::VectorXd& y);

/// diag(s) A diag(s).
SparseMatrix scaled(const SparseMatrix& a, const Eigen::VectorXd& s);

/// Numbers between −1 and 1 from a seed, the same on every machine.
Eigen::VectorXd random_vector(Eigen::Index size, std::uint64_t seed);

/// A symmetric and positive definite matrix A as a product of triangular ones.
class Factorization {
 public:
  virtual ~Factorization() = default;
  /// A⁻¹ b. 0.04 s for a mesh of 250,000 vertices.
  virtual Eigen::VectorXd solve(const Eigen::VectorXd& b) const = 0;
};

/// The factors of a symmetric matrix; nullptr where it is not positive definite to the last digit. 2 to 4 s and 140 MB
/// for a mesh of 250,000 vertices, one thread. Supernodal factors (CHOLMOD) would be quicker, but need another library.
std::unique_ptr<Factorization> factorized(const SparseMatrix& a);

}  // namespace isobench
