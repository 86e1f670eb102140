#include "isobench/methods/sizing/limit.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace isobench {

namespace {

/// Solves Σ (U − u)²/s² = δ² over the lower neighbours u of a node. The neighbours are added in ascending order: a
/// neighbour at or above U does not change U, nor does any after it.
class Upwind {
 public:
  /// Adds a neighbour with value `value` at distance s, where `inverse_square` is 1/s². Returns U.
  double add(double value, double inverse_square, double delta) {
    if (weight_ == 0.0) base_ = value;  // values are relative to this one, to avoid cancellation in the quadratic
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

/// Computes all nodes of a pass from the values before it, so the result does not depend on the order of nodes or the
/// number of threads. A node depends only on lower nodes and is final once they are. So the number of passes is the
/// length of the longest chain of such nodes.
class ActiveNodes {
 public:
  ActiveNodes(const Band& band, const std::vector<float>& h0, double delta)
      : band_(band),
        h_(h0.begin(), h0.end()),
        next_(h0.size()),
        active_(h0.size(), 1),
        blocks_((h0.size() + block - 1) / block, 1),
        delta_(delta) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double s = band.spacing()[static_cast<Eigen::Index>(axis)];
      inverse_square_[axis] = 1.0 / (s * s);
    }
  }

  std::vector<float> run(Monitor& monitor) {
    while (std::any_of(blocks_.begin(), blocks_.end(), [](std::uint8_t flag) { return flag != 0; })) {
      monitor.check();
      compute();
      apply();
    }
    return {h_.begin(), h_.end()};
  }

 private:
  static constexpr std::size_t block = 1024;

  /// Calls visit(n) in parallel for the active nodes of all blocks that have one.
  template <typename Visit>
  void visit_active(const std::vector<std::uint8_t>& blocks, const std::vector<std::uint8_t>& active, Visit visit) {
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
      if (blocks[b] == 0) return;
      for (std::size_t n = b * block; n < std::min(active.size(), (b + 1) * block); ++n) {
        if (active[n] != 0) visit(n);
      }
    });
  }

  void compute() {
    visit_active(blocks_, active_, [&](std::size_t n) { next_[n] = limited(n); });
  }

  /// Lowers the nodes to their new values, and activates the neighbours of those that changed.
  void apply() {
    std::vector<std::uint8_t> roused(active_.size(), 0);
    std::vector<std::uint8_t> roused_blocks(blocks_.size(), 0);
    visit_active(blocks_, active_, [&](std::size_t n) {
      if (!(next_[n] < h_[n])) return;
      h_[n] = next_[n];
      for (const std::int32_t other : lattice_neighbours(band_, n)) {
        if (other < 0) continue;
        const auto m = static_cast<std::size_t>(other);
        std::atomic_ref(roused[m]).store(1, std::memory_order_relaxed);
        std::atomic_ref(roused_blocks[m / block]).store(1, std::memory_order_relaxed);
      }
    });
    active_ = std::move(roused);
    blocks_ = std::move(roused_blocks);
  }

  double limited(std::size_t n) const {
    struct Lower {
      double value;
      double inverse_square;
    };
    std::array<Lower, 6> lower{};
    std::size_t count = 0;
    const LatticeNeighbours around = lattice_neighbours(band_, n);
    for (std::size_t side = 0; side < 6; ++side) {
      if (around[side] < 0) continue;
      const double value = h_[static_cast<std::size_t>(around[side])];
      if (!(value < h_[n])) continue;
      std::size_t at = count++;
      for (; at > 0 && lower[at - 1].value > value; --at) lower[at] = lower[at - 1];
      lower[at] = {value, inverse_square_[side / 2]};
    }
    Upwind upwind;
    double u = h_[n];
    for (std::size_t k = 0; k < count; ++k) u = upwind.add(lower[k].value, lower[k].inverse_square, delta_);
    return std::min(u, h_[n]);
  }

  const Band& band_;
  std::vector<double> h_;
  std::vector<double> next_;
  std::vector<std::uint8_t> active_;  // for each node: whether a neighbour has changed
  std::vector<std::uint8_t> blocks_;  // for each `block` nodes: whether one of them is active
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
  return ActiveNodes(band, h0, delta).run(monitor);
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
