#include "isobench/metrics/finite_elements/eigenvalues.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "isobench/metrics/finite_elements/sparse_matrix.h"

namespace isobench {

namespace {

/// A pivot that later ones are divided by.
double not_zero(double pivot) { return pivot == 0.0 ? -std::numeric_limits<double>::min() : pivot; }

/// The number of eigenvalues below x: that of negative pivots of T − x (Sturm).
std::size_t count_below(const Tridiagonal& t, double x) {
  std::size_t count = 0;
  double pivot = 1.0;
  for (std::size_t i = 0; i < t.diagonal.size(); ++i) {
    const double before = i == 0 ? 0.0 : t.beside[i - 1] * t.beside[i - 1] / pivot;
    pivot = not_zero(t.diagonal[i] - x - before);
    if (pivot < 0.0) ++count;
  }
  return count;
}

}  // namespace

// By bisection.
double Tridiagonal::largest() const {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    // Gershgorin's circles.
    const double radius = (i == 0 ? 0.0 : beside[i - 1]) + (i + 1 < diagonal.size() ? beside[i] : 0.0);
    low = std::min(low, diagonal[i] - radius);
    high = std::max(high, diagonal[i] + radius);
  }
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (!(low < middle && middle < high)) return middle;
    (count_below(*this, middle) == diagonal.size() ? high : low) = middle;
  }
}

// The last component of the unit eigenvector times the last number beside the diagonal (Golub and Van Loan, theorem
// 10.1.2). The eigenvector follows from the pivots of T − value: from the top down to its largest component and from
// the bottom up to it, which is where the two kinds of pivots fit together best (Parlett and Dhillon 1997).
double Tridiagonal::error_of(double ritz_value) const {
  const std::size_t steps = diagonal.size();
  std::vector<double> down(steps);
  std::vector<double> up(steps);
  for (std::size_t i = 0; i < steps; ++i) {
    const std::size_t j = steps - 1 - i;
    down[i] = not_zero(diagonal[i] - ritz_value - (i == 0 ? 0.0 : beside[i - 1] * beside[i - 1] / down[i - 1]));
    up[j] = not_zero(diagonal[j] - ritz_value - (i == 0 ? 0.0 : beside[j] * beside[j] / up[j + 1]));
  }
  std::size_t peak = 0;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < steps; ++i) {
    const double misfit = std::abs(down[i] + up[i] - (diagonal[i] - ritz_value));
    if (misfit < best) peak = i;
    best = std::min(best, misfit);
  }
  double squares = 1.0;
  double component = 1.0;
  for (std::size_t i = peak; i-- > 0;) {
    component *= -beside[i] / down[i];
    squares += component * component;
  }
  component = 1.0;
  for (std::size_t i = peak + 1; i < steps; ++i) {
    component *= -beside[i - 1] / up[i];
    squares += component * component;
  }
  return beside[steps - 1] * std::abs(component) / std::sqrt(squares);
}

std::optional<double> largest_eigenvalue(Eigen::Index size, const LinearMap& times_a, const LinearMap& over_b,
                                         double tolerance, int max_steps, Monitor& monitor) {
  Tridiagonal t;
  // v and w = B v, with v·w = 1; `next` becomes the next w, and `solved` the next v.
  Eigen::VectorXd w = random_vector(size, 1);
  Eigen::VectorXd v = w;
  Eigen::VectorXd w_before = Eigen::VectorXd::Zero(size);
  Eigen::VectorXd next(size);
  if (over_b) over_b(w, v);
  const double scale = 1.0 / std::sqrt(ordered_dot(v, w));
  v *= scale;
  w *= scale;
  for (int step = 1; step <= max_steps; ++step) {
    monitor.check();
    times_a(v, next);
    t.diagonal.push_back(ordered_dot(v, next));
    next -= t.diagonal.back() * w;
    if (step > 1) next -= t.beside.back() * w_before;
    if (over_b)
      over_b(next, v);
    else
      v = next;
    t.beside.push_back(std::sqrt(std::max(0.0, ordered_dot(v, next))));
    if (!std::isfinite(t.beside.back()) || !std::isfinite(t.diagonal.back())) return std::nullopt;
    // At every step, so that none is missed: once it has converged, copies hide it for a while.
    const double largest = t.largest();
    if (t.error_of(largest) <= tolerance * largest) return largest;
    if (t.beside.back() == 0.0) return std::nullopt;
    w_before.swap(w);
    w = next / t.beside.back();
    v /= t.beside.back();
  }
  return std::nullopt;
}

}  // namespace isobench
