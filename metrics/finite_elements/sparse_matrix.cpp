#include "isobench/metrics/finite_elements/sparse_matrix.h"

#include <Eigen/SparseCholesky>

namespace isobench {

namespace {

class SimplicialFactorization : public Factorization {
 public:
  explicit SimplicialFactorization(const SparseMatrix& a) : factors_(a) {}
  bool exists() const { return factors_.info() == Eigen::Success && factors_.vectorD().minCoeff() > 0.0; }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const override { return factors_.solve(b); }

 private:
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
};

}  // namespace

double ordered_dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return ordered_sum(a.size(), [&](Eigen::Index first, Eigen::Index length) {
    return a.segment(first, length).dot(b.segment(first, length));
  });
}

double multiply(const SparseMatrix& a, const Eigen::VectorXd& x, Eigen::VectorXd& y) {
  y.resize(a.rows());
  return ordered_sum(a.rows(), [&](Eigen::Index first, Eigen::Index length) {
    y.segment(first, length).noalias() = a.middleRows(first, length) * x;
    return x.segment(first, length).dot(y.segment(first, length));
  });
}

SparseMatrix scaled(const SparseMatrix& a, const Eigen::VectorXd& s) { return s.asDiagonal() * a * s.asDiagonal(); }

Eigen::VectorXd random_vector(Eigen::Index size, std::uint64_t seed) {
  Eigen::VectorXd result(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    // SplitMix64 (Steele, Lea and Flood 2014); the upper 53 bits make a number in [0, 1).
    seed += 0x9e3779b97f4a7c15U;
    std::uint64_t z = seed;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    z ^= z >> 31U;
    result[i] = 2.0 * (static_cast<double>(z >> 11U) * 0x1p-53) - 1.0;
  }
  return result;
}

std::unique_ptr<Factorization> factorized(const SparseMatrix& a) {
  auto factors = std::make_unique<SimplicialFactorization>(a);
  return factors->exists() ? std::move(factors) : nullptr;
}

}  // namespace isobench
