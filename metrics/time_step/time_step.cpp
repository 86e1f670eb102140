#include "isobench/metrics/time_step/time_step.h"

#include "isobench/metrics/finite_elements/eigenvalues.h"

namespace isobench {

namespace {

constexpr double tolerance = 1e-7;
constexpr int max_steps = 2000;

/// y = M⁻¹ x to 5e-8 for a mass matrix with ones on its diagonal, whose eigenvalues are between 1/2 and 2. Chebyshev's
/// iteration needs no scalar products, and as a fixed polynomial of M it is symmetric (Saad, Iterative Methods for
/// Sparse Linear Systems, algorithm 12.1).
class InverseMass {
 public:
  explicit InverseMass(const SparseMatrix& mass) : mass_(mass) {}
  void operator()(const Eigen::VectorXd& x, Eigen::VectorXd& y) {
    constexpr double centre = 1.25;
    constexpr double radius = 0.75;
    constexpr int steps = 16;  // each divides the error by 3
    double rho = radius / centre;
    residual_ = x;
    change_ = x / centre;
    y = change_;
    for (int step = 1; step < steps; ++step) {
      multiply(mass_, change_, product_);
      residual_ -= product_;
      const double next = 1.0 / (2.0 * centre / radius - rho);
      change_ = next * rho * change_ + 2.0 * next / radius * residual_;
      y += change_;
      rho = next;
    }
  }

 private:
  const SparseMatrix& mass_;
  Eigen::VectorXd residual_;
  Eigen::VectorXd change_;
  Eigen::VectorXd product_;
};

}  // namespace

std::optional<double> consistent_step_factor(const FiniteElements& elements, const Eigen::VectorXd& h,
                                             Monitor& monitor) {
  const Eigen::VectorXd to_ones = elements.mass.diagonal().cwiseSqrt().cwiseInverse();
  // K x = λ diag(1/h) M diag(1/h) x, with the unknowns scaled so that M has ones on its diagonal.
  const SparseMatrix a = scaled(elements.stiffness, h.cwiseProduct(to_ones));
  const SparseMatrix mass = scaled(elements.mass, to_ones);
  const auto times_a = [&a](const Eigen::VectorXd& x, Eigen::VectorXd& y) { multiply(a, x, y); };
  return largest_eigenvalue(a.rows(), times_a, InverseMass(mass), tolerance, max_steps, monitor);
}

}  // namespace isobench
