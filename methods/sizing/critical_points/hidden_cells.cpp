#include "isobench/methods/sizing/critical_points/hidden_cells.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace isobench {

namespace {

using Four = std::array<float, 4>;
using Taps = std::array<float, 64>;  // x fastest

/// The Bernstein coefficients of the cubic on an interval, from the four spline coefficients around it.
Four bernstein(Kernel kernel, float a, float b, float c, float d) {
  if (kernel == Kernel::catmull_rom) return {b, b + (c - a) / 6.0F, c - (d - b) / 6.0F, c};
  return {(a + 4.0F * b + c) / 6.0F, (2.0F * b + c) / 3.0F, (b + 2.0F * c) / 3.0F, (b + 4.0F * c + d) / 6.0F};
}

void to_bernstein(Kernel kernel, Taps& taps) {
  for (const std::size_t step : {std::size_t{1}, std::size_t{4}, std::size_t{16}}) {
    for (std::size_t line = 0; line < 16; ++line) {
      const std::size_t first = step == 1 ? 4 * line : step == 4 ? line / 4 * 16 + line % 4 : line;
      const Four all =
          bernstein(kernel, taps[first], taps[first + step], taps[first + 2 * step], taps[first + 3 * step]);
      for (std::size_t n = 0; n < 4; ++n) taps[first + n * step] = all[n];
    }
  }
}

/// Four layers of coefficients, for one thread. Rows and columns begin at node −1 and end two beyond the last node.
struct Workspace {
  std::array<std::vector<float>, 4> layers;
  std::vector<float> least, most;          // minimum and maximum over the four layers
  std::vector<float> row_least, row_most;  // and over four rows
};

class Search {
 public:
  explicit Search(const Isosurface& surface)
      : surface_(surface),
        size_(surface.lattice().size),
        width_(static_cast<std::size_t>(size_[0]) + 3),
        height_(static_cast<std::size_t>(size_[1]) + 3),
        // If the coefficients are within [m, M], so is a B-spline. The negative weights of Catmull-Rom sum to at most
        // (1.25³ − 1)/2 in magnitude.
        beyond_(surface.kernel() == Kernel::catmull_rom ? 0.4766F : 0.0F) {}

  std::vector<std::array<int, 3>> in_layer(int k, Workspace& work) const {
    load(k, work);
    std::vector<std::array<int, 3>> found;
    for (int j = 0; j + 1 < size_[1]; ++j) {
      reduce_rows(static_cast<std::size_t>(j), work);
      for (int i = 0; i + 1 < size_[0]; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const float* low = &work.row_least[at];
        const float* high = &work.row_most[at];
        const float least = std::min(std::min(low[0], low[1]), std::min(low[2], low[3]));
        const float most = std::max(std::max(high[0], high[1]), std::max(high[2], high[3]));
        const float margin = beyond_ * (most - least);
        if (least - margin > 0.0F || most + margin <= 0.0F) continue;
        if (is_hidden(at, static_cast<std::size_t>(j), work)) found.push_back({i, j, k});
      }
    }
    return found;
  }

 private:
  void load(int k, Workspace& work) const {
    for (int t = 0; t < 4; ++t) {
      std::vector<float>& layer = work.layers[static_cast<std::size_t>(t)];
      layer.resize(width_ * height_);
      float* out = layer.data();
      for (int j = -1; j < size_[1] + 2; ++j) {
        for (int i = -1; i < size_[0] + 2; ++i) *out++ = surface_.coefficient(i, j, k - 1 + t);
      }
    }
    const auto& [a, b, c, d] = work.layers;
    work.least.resize(a.size());
    work.most.resize(a.size());
    for (std::size_t n = 0; n < a.size(); ++n) {
      work.least[n] = std::min(std::min(a[n], b[n]), std::min(c[n], d[n]));
      work.most[n] = std::max(std::max(a[n], b[n]), std::max(c[n], d[n]));
    }
  }

  void reduce_rows(std::size_t j, Workspace& work) const {
    work.row_least.resize(width_);
    work.row_most.resize(width_);
    const float* low = &work.least[j * width_];
    const float* high = &work.most[j * width_];
    for (std::size_t i = 0; i < width_; ++i) {
      work.row_least[i] =
          std::min(std::min(low[i], low[i + width_]), std::min(low[i + 2 * width_], low[i + 3 * width_]));
      work.row_most[i] =
          std::max(std::max(high[i], high[i + width_]), std::max(high[i + 2 * width_], high[i + 3 * width_]));
    }
  }

  bool is_hidden(std::size_t i, std::size_t j, const Workspace& work) const {
    Taps taps;
    auto* out = taps.data();
    for (const std::vector<float>& layer : work.layers) {
      for (std::size_t row = 0; row < 4; ++row) out = std::copy_n(&layer[(j + row) * width_ + i], 4, out);
    }
    to_bernstein(surface_.kernel(), taps);
    const auto is_inside = [](float value) { return value > 0.0F; };
    const auto inside = std::count_if(taps.begin(), taps.end(), is_inside);
    if (inside == 0 || inside == 64) return false;
    // The first and last coefficients along each axis are the values at the corners.
    int corners = 0;
    for (const std::size_t corner : {0, 3, 12, 15, 48, 51, 60, 63}) corners += is_inside(taps[corner]) ? 1 : 0;
    return corners == 0 || corners == 8;
  }

  const Isosurface& surface_;
  std::array<int, 3> size_;
  std::size_t width_;
  std::size_t height_;
  float beyond_;
};

}  // namespace

std::vector<std::array<int, 3>> hidden_cells(const Isosurface& surface) {
  const Search search(surface);
  const int layers = surface.lattice().size[2] - 1;
  std::vector<std::vector<std::array<int, 3>>> found(static_cast<std::size_t>(layers));
  tbb::enumerable_thread_specific<Workspace> workspaces;
  tbb::parallel_for(0, layers,
                    [&](int k) { found[static_cast<std::size_t>(k)] = search.in_layer(k, workspaces.local()); });
  std::vector<std::array<int, 3>> all;
  for (const auto& in_layer : found) all.insert(all.end(), in_layer.begin(), in_layer.end());
  return all;
}

}  // namespace isobench
