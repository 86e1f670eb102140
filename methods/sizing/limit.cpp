#include "methods/sizing/limit.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace isobench {

namespace {

/// The lower neighbours of a node so far and the U that solves Σ (U − u)²/s² = δ² over them. Marching accepts
/// neighbours from the lowest up, so each is added once and a neighbour at or above U changes nothing, nor does any
/// after it.
class Upwind {
 public:
  /// Returns U after adding a neighbour at `value` whose distance is s.
  double add(double value, double inverse_square, double delta) {
    if (weight_ == 0.0) base_ = value;  // values count from here, so that the quadratic does not cancel
    const double u = value - base_;
    if (weight_ > 0.0 && solution_ <= u) return base_ + solution_;
    weight_ += inverse_square;
    first_ += inverse_square * u;
    second_ += inverse_square * u * u;
    const double root = first_ * first_ - weight_ * (second_ - delta * delta);
    solution_ = (first_ + std::sqrt(std::max(0.0, root))) / weight_;
    return base_ + solution_;
  }

 private:
  double base_ = 0.0;
  double solution_ = 0.0;  // U − base
  double weight_ = 0.0;    // Σ 1/s²
  double first_ = 0.0;     // Σ u/s²
  double second_ = 0.0;    // Σ u²/s²
};

class FastMarching {
 public:
  FastMarching(const Band& band, const std::vector<float>& h0, double delta)
      : band_(band), h_(h0.begin(), h0.end()), upwind_(h0.size()), done_(h0.size(), 0), delta_(delta) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double s = band.spacing()[static_cast<Eigen::Index>(axis)];
      inverse_square_[axis] = 1.0 / (s * s);
    }
  }

  std::vector<float> run(Monitor& monitor) {
    std::vector<Entry> entries(h_.size());
    for (std::size_t n = 0; n < h_.size(); ++n) entries[n] = {h_[n], static_cast<std::int32_t>(n)};
    Queue queue(std::greater<>(), std::move(entries));
    std::size_t accepted = 0;
    while (!queue.empty()) {
      const auto [value, n] = queue.top();
      queue.pop();
      const auto node = static_cast<std::size_t>(n);
      if (done_[node] != 0) continue;  // an entry from before the value fell
      done_[node] = 1;
      if (++accepted % 65536 == 0) monitor.progress(static_cast<double>(accepted) / static_cast<double>(h_.size()));
      const LatticeNeighbours around = lattice_neighbours(band_, node);
      for (std::size_t side = 0; side < 6; ++side) {
        if (around[side] >= 0) tell(static_cast<std::size_t>(around[side]), value, side, queue);
      }
    }
    return {h_.begin(), h_.end()};
  }

 private:
  using Entry = std::pair<double, std::int32_t>;
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

  /// Tells node n of a neighbour accepted at `value`.
  void tell(std::size_t n, double value, std::size_t side, Queue& queue) {
    if (done_[n] != 0) return;
    const double limited = upwind_[n].add(value, inverse_square_[side / 2], delta_);
    if (!(limited < h_[n])) return;
    h_[n] = limited;
    queue.emplace(limited, static_cast<std::int32_t>(n));
  }

  const Band& band_;
  std::vector<double> h_;
  std::vector<Upwind> upwind_;
  std::vector<char> done_;
  double delta_;
  std::array<double, 3> inverse_square_{};
};

}  // namespace

LatticeNeighbours lattice_neighbours(const Band& band, std::size_t n) {
  const auto [i, j, k] = band.node(n);
  return {band.find(i - 1, j, k), band.find(i + 1, j, k), band.find(i, j - 1, k),
          band.find(i, j + 1, k), band.find(i, j, k - 1), band.find(i, j, k + 1)};
}

std::vector<float> limit_gradient(const Band& band, const std::vector<float>& h0, double delta, Monitor& monitor) {
  return FastMarching(band, h0, delta).run(monitor);
}

double upwind_gradient_norm(const Band& band, const std::vector<float>& h, std::size_t node) {
  const LatticeNeighbours around = lattice_neighbours(band, node);
  double sum = 0.0;
  for (std::size_t side = 0; side < 6; ++side) {
    if (around[side] < 0) continue;
    const double rise = static_cast<double>(h[node]) - static_cast<double>(h[static_cast<std::size_t>(around[side])]);
    const double slope = std::max(0.0, rise) / band.spacing()[static_cast<Eigen::Index>(side / 2)];
    sum += slope * slope;
  }
  return std::sqrt(sum);
}

}  // namespace isobench
