#include "metrics/sign_lattice.h"

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
  Refinement(const Isosurface& surface, int k, SignLattice& signs)
      : surface_(surface),
        k_(k),
        n_(surface.lattice().size),
        padded_(static_cast<std::size_t>(n_[0]) + 3),
        signs_(signs) {
    for (int p = 0; p < k; ++p) weights_.push_back(kernel_weights(surface.kernel(), static_cast<double>(p) / k));
  }

  /// All refined slabs between lattice layer `layer` and the next.
  void refine(int layer, Workspace& work) const {
    for (int t = 0; t < 4; ++t) load_layer(layer - 1 + t, work.layers[static_cast<std::size_t>(t)]);
    const int phases = layer + 1 < n_[2] ? k_ : 1;
    for (int p = 0; p < phases; ++p) {
      const int z = layer * k_ + p;
      if (z >= 2 && z < signs_.size()[2] - 2) refine_slab(z, weights_[static_cast<std::size_t>(p)], work);
    }
  }

 private:
  // Rows begin with coefficient −1 and end with n + 1, so that the four taps of every cell exist.
  void load_layer(int layer, std::vector<double>& values) const {
    values.resize(padded_ * static_cast<std::size_t>(n_[1]));
    double* out = values.data();
    for (int j = 0; j < n_[1]; ++j) {
      for (int i = -1; i < n_[0] + 2; ++i) *out++ = surface_.coefficient(i, j, layer);
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
    work.phase.resize(static_cast<std::size_t>(n_[0]));
    combine({layers[0].data(), layers[1].data(), layers[2].data(), layers[3].data()}, weights, work.slab.size(),
            work.slab.data());
    const auto slab_row = [&](int j) {
      return work.slab.data() + padded_ * static_cast<std::size_t>(std::clamp(j, 0, n_[1] - 1));
    };
    for (int y = 2; y < signs_.size()[1] - 2; ++y) {
      const int j = y / k_;
      combine({slab_row(j - 1), slab_row(j), slab_row(j + 1), slab_row(j + 2)},
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
    bits[0] &= ~std::uint64_t{3};
    for (auto x = static_cast<std::size_t>(signs_.size()[0]) - 2; x < static_cast<std::size_t>(signs_.size()[0]); ++x) {
      bits[x / 64] &= ~(std::uint64_t{1} << (x % 64));
    }
  }

  const Isosurface& surface_;
  int k_;
  std::array<int, 3> n_;
  std::size_t padded_;
  SignLattice& signs_;
  std::vector<Weights> weights_;
};

}  // namespace

SignLattice refined_signs(const Isosurface& surface, int k, Monitor& monitor) {
  const std::array<int, 3>& n = surface.lattice().size;
  SignLattice signs({k * (n[0] - 1) + 1, k * (n[1] - 1) + 1, k * (n[2] - 1) + 1});
  const Refinement refinement(surface, k, signs);
  tbb::enumerable_thread_specific<Workspace> workspaces;
  constexpr int batch = 16;  // lattice layers between two reports of progress
  for (int begin = 0; begin < n[2]; begin += batch) {
    monitor.progress(static_cast<double>(begin) / n[2]);
    tbb::parallel_for(begin, std::min(begin + batch, n[2]),
                      [&](int layer) { refinement.refine(layer, workspaces.local()); });
  }
  return signs;
}

}  // namespace isobench
