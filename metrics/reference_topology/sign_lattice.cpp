#include "isobench/metrics/reference_topology/sign_lattice.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace isobench {

namespace {

using Weights = std::array<double, 4>;

Weights kernel_weights(Kernel kernel, double t) {
  const double s = 1.0 - t;
  if (kernel == Kernel::catmull_rom) {
    return {(-t * t * t + 2.0 * t * t - t) / 2.0, (3.0 * t * t * t - 5.0 * t * t + 2.0) / 2.0,
            (-3.0 * t * t * t + 4.0 * t * t + t) / 2.0, (t * t * t - t * t) / 2.0};
  }
  return {s * s * s / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0, (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0,
          t * t * t / 6.0};
}

/// What one thread needs to refine the nodes of a slab; reused from slab to slab.
struct Workspace {
  std::array<std::vector<double>, 4> layers;  ///< coefficients of four lattice layers, rows padded to (n + 3)
  std::vector<double> slab;                   ///< refined along z
  std::vector<double> row;                    ///< refined along z and y
  std::vector<double> phase;                  ///< one phase of a row refined along all axes
};

class Refinement {
 public:
  Refinement(const Isosurface& surface, const NodeBox& box, int k, int factor, SignLattice& signs)
      : surface_(surface),
        box_(box),
        k_(k * factor),
        closed_(2 * factor),
        padded_(static_cast<std::size_t>(box.high[0] - box.low[0]) + 4),
        signs_(signs) {
    for (int p = 0; p < k_; ++p) weights_.push_back(kernel_weights(surface.kernel(), static_cast<double>(p) / k_));
  }

  /// All refined slabs between lattice layer `layer` and the next.
  void refine(int layer, Workspace& work) const {
    for (int t = 0; t < 4; ++t) load_layer(layer - 1 + t, work.layers[static_cast<std::size_t>(t)]);
    const int phases = layer < box_.high[2] ? k_ : 1;
    for (int p = 0; p < phases; ++p) {
      const int z = (layer - box_.low[2]) * k_ + p;
      if (!is_border(z, 2)) refine_slab(z, weights_[static_cast<std::size_t>(p)], work);
    }
  }

 private:
  /// Whether a node, by its number along an axis of the box, is so near the volume's border that it counts as outside.
  bool is_border(int node, std::size_t axis) const {
    const int from_low = box_.low[axis] * k_ + node;
    const int from_high = (surface_.lattice().size[axis] - 1) * k_ - from_low;
    return std::min(from_low, from_high) < closed_;
  }

  // Rows and columns begin one coefficient before the box and end two beyond it, so that every cell has its taps.
  void load_layer(int layer, std::vector<double>& values) const {
    values.resize(padded_ * static_cast<std::size_t>(box_.high[1] - box_.low[1] + 4));
    double* out = values.data();
    for (int j = box_.low[1] - 1; j < box_.high[1] + 3; ++j) {
      for (int i = box_.low[0] - 1; i < box_.high[0] + 3; ++i) *out++ = surface_.coefficient(i, j, layer);
    }
  }

  static void combine(std::array<const double*, 4> in, const Weights& w, std::size_t count, double* out) {
    for (std::size_t i = 0; i < count; ++i) {
      out[i] = w[0] * in[0][i] + w[1] * in[1][i] + w[2] * in[2][i] + w[3] * in[3][i];
    }
  }

  void refine_slab(int z, const Weights& weights, Workspace& work) const {
    const auto& layers = work.layers;
    work.slab.resize(layers[0].size());
    work.row.resize(padded_);
    work.phase.resize(padded_ - 3);
    combine({layers[0].data(), layers[1].data(), layers[2].data(), layers[3].data()}, weights, work.slab.size(),
            work.slab.data());
    for (int y = 0; y < signs_.size()[1]; ++y) {
      if (is_border(y, 1)) continue;
      // The last node begins no cell, but the four rows from there exist; the fourth has weight 0.
      const double* rows = work.slab.data() + padded_ * static_cast<std::size_t>(y / k_);
      combine({rows, rows + padded_, rows + 2 * padded_, rows + 3 * padded_},
              weights_[static_cast<std::size_t>(y % k_)], padded_, work.row.data());
      refine_row(y, z, work);
    }
  }

  void refine_row(int y, int z, Workspace& work) const {
    std::uint64_t* bits = signs_.row(y, z);
    const double* row = work.row.data();
    for (int p = 0; p < k_; ++p) {
      const std::size_t count = work.phase.size() - (p == 0 ? 0 : 1);  // the last lattice node begins no cell
      combine({row, row + 1, row + 2, row + 3}, weights_[static_cast<std::size_t>(p)], count, work.phase.data());
      auto x = static_cast<std::size_t>(p);
      for (std::size_t i = 0; i < count; ++i, x += static_cast<std::size_t>(k_)) {
        bits[x / 64] |= static_cast<std::uint64_t>(work.phase[i] > 0.0) << (x % 64);
      }
    }
    const auto close = [&](int x) { bits[x / 64] &= ~(std::uint64_t{1} << (x % 64)); };
    for (int x = 0; x < signs_.size()[0] && is_border(x, 0); ++x) close(x);
    for (int x = signs_.size()[0] - 1; x >= 0 && is_border(x, 0); --x) close(x);
  }

  const Isosurface& surface_;
  NodeBox box_;
  int k_;
  int closed_;  // layers of nodes at the volume's border that count as outside
  std::size_t padded_;
  SignLattice& signs_;
  std::vector<Weights> weights_;
};

}  // namespace

SignLattice refined_signs(const Isosurface& surface, int k, Monitor& monitor) {
  const std::array<int, 3>& n = surface.lattice().size;
  return refined_signs(surface, NodeBox{{0, 0, 0}, {n[0] - 1, n[1] - 1, n[2] - 1}}, k, 1, monitor);
}

SignLattice refined_signs(const Isosurface& surface, const NodeBox& box, int k, int factor, Monitor& monitor) {
  std::array<int, 3> size{};
  for (std::size_t axis = 0; axis < 3; ++axis) size[axis] = k * factor * (box.high[axis] - box.low[axis]) + 1;
  SignLattice signs(size);
  const Refinement refinement(surface, box, k, factor, signs);
  tbb::enumerable_thread_specific<Workspace> workspaces;
  constexpr int batch = 16;  // lattice layers between two checks for cancellation
  for (int begin = box.low[2]; begin <= box.high[2]; begin += batch) {
    monitor.check();
    tbb::parallel_for(begin, std::min(begin + batch, box.high[2] + 1),
                      [&](int layer) { refinement.refine(layer, workspaces.local()); });
  }
  return signs;
}

}  // namespace isobench
