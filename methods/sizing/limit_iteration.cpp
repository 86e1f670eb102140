// Equations 2 and 3 as published.
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

#include "isobench/methods/sizing/limit.h"

namespace isobench {

namespace {

using Range = tbb::blocked_range<std::size_t>;

class ExplicitIteration {
 public:
  ExplicitIteration(const Band& band, const std::vector<float>& h0, double delta)
      : h_(h0.begin(), h0.end()), next_(h_), around_(h0.size()), delta_(delta), dt_(band.spacing().minCoeff() / 6.0) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double s = band.spacing()[static_cast<Eigen::Index>(axis)];
      inverse_square_[axis] = 1.0 / (s * s);
    }
    tbb::parallel_for(Range(0, h_.size(), 4096), [&](const Range& range) {
      for (std::size_t n = range.begin(); n < range.end(); ++n) around_[n] = lattice_neighbours(band, n);
    });
  }

  /// Performs one step on all nodes and returns the largest relative change.
  double step() {
    const double change = tbb::parallel_reduce(
        Range(0, h_.size(), 4096), 0.0,
        [&](const Range& range, double largest) {
          for (std::size_t n = range.begin(); n < range.end(); ++n) {
            const double fall = dt_ * std::max(0.0, gradient_norm(n) - delta_);
            next_[n] = h_[n] - fall;
            largest = std::max(largest, fall / h_[n]);
          }
          return largest;
        },
        [](double a, double b) { return std::max(a, b); });
    std::swap(h_, next_);
    return change;
  }

  std::vector<float> result() const { return {h_.begin(), h_.end()}; }

 private:
  double gradient_norm(std::size_t n) const {
    double sum = 0.0;
    for (std::size_t side = 0; side < 6; ++side) {
      if (around_[n][side] < 0) continue;
      const double rise = std::max(0.0, h_[n] - h_[static_cast<std::size_t>(around_[n][side])]);
      sum += rise * rise * inverse_square_[side / 2];
    }
    return std::sqrt(sum);
  }

  std::vector<double> h_;
  std::vector<double> next_;
  std::vector<LatticeNeighbours> around_;
  std::array<double, 3> inverse_square_{};
  double delta_;
  double dt_;
};

}  // namespace

std::vector<float> iterate_limit(const Band& band, const std::vector<float>& h0, double delta, double stop,
                                 Monitor& monitor) {
  ExplicitIteration iteration(band, h0, delta);
  int passes = 0;
  for (double change = 1.0; change >= stop; ++passes) {
    monitor.check();
    change = iteration.step();
  }
  monitor.set("limiter/passes", passes);
  return iteration.result();
}

}  // namespace isobench
