// The steps that change a volume's lattice.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "isobench/datasets/preparation/prepare_steps.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

/// Where the nodes of one resampled axis lie among the old ones.
struct Taps {
  std::vector<int> lower;
  std::vector<float> weight;  // of the node above `lower`
  double spacing = 1.0;
};

Taps taps_of(int count, double from, double to, int axis) {
  if (!(to > 0.0)) throw DataError(fmt::format("resample: the spacing of axis {} must be > 0 mm", axis));
  const double length = from * (count - 1);
  if (!(length / to < 1e6))
    throw DataError(fmt::format("resample: a spacing of {} mm makes axis {} too long; take a larger one", to, axis));
  const int fresh = count == 1 ? 1 : std::max(2, static_cast<int>(std::lround(length / to)) + 1);
  Taps taps;
  taps.spacing = fresh == 1 ? from : length / (fresh - 1);
  for (int n = 0; n < fresh; ++n) {
    // In integers as far as possible, so that nodes that fall on old ones do so exactly.
    const long long numerator = static_cast<long long>(n) * (count - 1);
    const long long denominator = std::max(fresh - 1, 1);
    const int lower = static_cast<int>(std::min<long long>(numerator / denominator, std::max(count - 2, 0)));
    taps.lower.push_back(lower);
    taps.weight.push_back(
        static_cast<float>(static_cast<double>(numerator - lower * denominator) / static_cast<double>(denominator)));
  }
  return taps;
}

Volume with_size(const Volume& volume, const std::array<int, 3>& size, float value = 0.0F) {
  // As for files: 2^40 nodes are beyond any volume, and beyond 2^64 their number is not theirs any more.
  if (static_cast<double>(size[0]) * size[1] * size[2] > static_cast<double>(1LL << 40U)) {
    throw DataError(fmt::format("a volume of {} × {} × {} nodes would be too large; pad or resample it less", size[0],
                                size[1], size[2]));
  }
  Volume result;
  result.lattice = volume.lattice;
  result.lattice.size = size;
  result.samples.assign(result.lattice.nodes(), value);
  return result;
}

}  // namespace

void resample(Volume& volume, const Eigen::Vector3d& spacing) {
  Taps taps[3];
  std::array<int, 3> size{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int a = static_cast<int>(axis);
    taps[axis] = taps_of(volume.lattice.size[axis], volume.lattice.spacing[a], spacing[a], a);
    size[axis] = static_cast<int>(taps[axis].lower.size());
  }
  Volume result = with_size(volume, size);
  for (int axis = 0; axis < 3; ++axis) result.lattice.spacing[axis] = taps[axis].spacing;
  const auto above = [&](int n, std::size_t axis) { return std::min(n + 1, volume.lattice.size[axis] - 1); };
  tbb::parallel_for(0, size[2], [&](int k) {
    const int z = taps[2].lower[static_cast<std::size_t>(k)];
    const float wz = taps[2].weight[static_cast<std::size_t>(k)];
    for (int j = 0; j < size[1]; ++j) {
      const int y = taps[1].lower[static_cast<std::size_t>(j)];
      const float wy = taps[1].weight[static_cast<std::size_t>(j)];
      const float* rows[] = {&volume.samples[volume.lattice.index(0, y, z)],
                             &volume.samples[volume.lattice.index(0, above(y, 1), z)],
                             &volume.samples[volume.lattice.index(0, y, above(z, 2))],
                             &volume.samples[volume.lattice.index(0, above(y, 1), above(z, 2))]};
      float* out = &result.samples[result.lattice.index(0, j, k)];
      for (int i = 0; i < size[0]; ++i) {
        const int x = taps[0].lower[static_cast<std::size_t>(i)];
        const int x1 = above(x, 0);
        const float wx = taps[0].weight[static_cast<std::size_t>(i)];
        const auto along = [&](const float* row) { return (1.0F - wx) * row[x] + wx * row[x1]; };
        const float lower = (1.0F - wy) * along(rows[0]) + wy * along(rows[1]);
        const float upper = (1.0F - wy) * along(rows[2]) + wy * along(rows[3]);
        out[i] = (1.0F - wz) * lower + wz * upper;
      }
    }
  });
  volume = std::move(result);
}

void subsample(Volume& volume, int factor) {
  if (factor < 1) throw DataError("subsample: the factor must be at least 1");
  std::array<int, 3> size{};
  for (std::size_t axis = 0; axis < 3; ++axis) size[axis] = volume.lattice.size[axis] / factor;
  if (*std::min_element(size.begin(), size.end()) < 1) {
    throw DataError(
        fmt::format("subsample: a factor of {} leaves no node of a volume of {} × {} × {}; take a smaller one", factor,
                    volume.lattice.size[0], volume.lattice.size[1], volume.lattice.size[2]));
  }
  Volume result = with_size(volume, size);
  const double scale = 1.0 / (static_cast<double>(factor) * factor * factor);
  tbb::parallel_for(0, size[2], [&](int k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        double sum = 0.0;
        for (int z = 0; z < factor; ++z) {
          for (int y = 0; y < factor; ++y) {
            for (int x = 0; x < factor; ++x) sum += volume.at(i * factor + x, j * factor + y, k * factor + z);
          }
        }
        result.at(i, j, k) = static_cast<float>(scale * sum);
      }
    }
  });
  result.lattice.origin = volume.lattice.to_world(0.5 * (factor - 1) * volume.lattice.spacing);
  result.lattice.spacing *= factor;
  volume = std::move(result);
}

void crop(Volume& volume, int margin) {
  const auto [nx, ny, nz] = volume.lattice.size;
  Eigen::Array3i low(nx, ny, nz);
  Eigen::Array3i high(-1, -1, -1);
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      const float* row = &volume.samples[volume.lattice.index(0, j, k)];
      const auto positive = [](float sample) { return sample > 0.0F; };
      const float* first = std::find_if(row, row + nx, positive);
      if (first == row + nx) continue;
      int last = nx - 1;
      while (!positive(row[last])) --last;
      low = low.min(Eigen::Array3i(static_cast<int>(first - row), j, k));
      high = high.max(Eigen::Array3i(last, j, k));
    }
  }
  if (high[0] < 0) throw DataError("crop: no sample is > 0; check the threshold or the labels before it");
  margin = std::clamp(margin, 0, std::max({nx, ny, nz}));
  low = (low - margin).max(0);
  high = (high + margin).min(Eigen::Array3i(nx, ny, nz) - 1);
  const Eigen::Array3i size = high - low + 1;
  Volume result = with_size(volume, {size[0], size[1], size[2]});
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      std::copy_n(&volume.samples[volume.lattice.index(low[0], j + low[1], k + low[2])], size[0],
                  &result.samples[result.lattice.index(0, j, k)]);
    }
  }
  result.lattice.origin = volume.lattice.to_world(low.cast<double>().matrix().cwiseProduct(volume.lattice.spacing));
  volume = std::move(result);
}

void pad(Volume& volume, int voxels, float value) {
  if (voxels < 0) throw DataError("pad: the number of voxels must not be negative");
  std::array<int, 3> size = volume.lattice.size;
  for (int& count : size) {
    if (count > std::numeric_limits<int>::max() - 2 * static_cast<long long>(voxels))
      throw DataError("pad: too many voxels");
    count += 2 * voxels;
  }
  Volume result = with_size(volume, size, value);
  for (int k = 0; k < volume.lattice.size[2]; ++k) {
    for (int j = 0; j < volume.lattice.size[1]; ++j) {
      std::copy_n(&volume.samples[volume.lattice.index(0, j, k)], volume.lattice.size[0],
                  &result.samples[result.lattice.index(voxels, j + voxels, k + voxels)]);
    }
  }
  result.lattice.origin = volume.lattice.to_world(-voxels * volume.lattice.spacing);
  volume = std::move(result);
}

void close_border(Volume& volume, const CloseBorder& step) {
  const auto size = volume.lattice.size;
  const Range range = sample_range(volume);
  const float limit = !step.use_minimum ? static_cast<float>(step.value) : step.object_below ? range.max : range.min;
  const auto close = [&](float& sample) {
    sample = step.object_below ? std::max(sample, limit) : std::min(sample, limit);
  };
  const auto in_layers = [&](int n, int count) { return n < step.layers || n >= count - step.layers; };
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      const bool whole_row = in_layers(k, size[2]) || in_layers(j, size[1]);
      float* row = &volume.samples[volume.lattice.index(0, j, k)];
      for (int i = 0; i < size[0]; ++i) {
        if (whole_row || in_layers(i, size[0])) close(row[i]);
      }
    }
  }
}

}  // namespace isobench
