#include "isobench/experiments/random_runs/random_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

namespace isobench {

namespace {

Lattice random_lattice(RandomNumbers& random) {
  Lattice lattice;
  for (int& nodes : lattice.size) nodes = 8 + random.below(10);
  lattice.spacing.y() = random.chance(0.5) ? 1.0 : random.between(1.0, 2.0);
  lattice.spacing.z() = random.chance(0.5) ? 1.0 : random.between(1.0, 7.0);
  return lattice;
}

// Calls `visit(i, j, k, sample)` for each node of `volume`.
template <class Visit>
void for_each_node(FloatVolume& volume, Visit&& visit) {
  const auto& [width, height, depth] = volume.lattice.size;
  for (int k = 0; k < depth; ++k) {
    for (int j = 0; j < height; ++j) {
      for (int i = 0; i < width; ++i) visit(i, j, k, volume.at(i, j, k));
    }
  }
}

// Averages each sample with its neighbours along one axis, 1 : 2 : 1.
void blur_along(std::size_t axis, FloatVolume& volume) {
  const FloatVolume before = volume;
  const int last = volume.lattice.size[axis] - 1;
  for_each_node(volume, [&](int i, int j, int k, float& sample) {
    std::array<int, 3> low{i, j, k};
    std::array<int, 3> high = low;
    low[axis] = std::max(low[axis] - 1, 0);
    high[axis] = std::min(high[axis] + 1, last);
    sample = 0.5F * sample + 0.25F * (before.at(low[0], low[1], low[2]) + before.at(high[0], high[1], high[2]));
  });
}

// White or blurred noise, stretched to [0, 1].
FloatVolume noise(const Lattice& lattice, RandomNumbers& random) {
  FloatVolume volume{lattice, std::vector<float>(lattice.nodes())};
  for (float& sample : volume.samples) sample = static_cast<float>(random.next());
  const int blurs = random.below(4);
  for (int blur = 0; blur < blurs; ++blur) {
    for (std::size_t axis = 0; axis < 3; ++axis) blur_along(axis, volume);
  }
  const auto [low, high] = std::minmax_element(volume.samples.begin(), volume.samples.end());
  const float least = *low;
  const float range = *high - least;
  for (float& sample : volume.samples) sample = (sample - least) / range;
  return volume;
}

// A value that at least a tenth of the samples are below, and a tenth above or at.
float random_quantile(const FloatVolume& volume, RandomNumbers& random) {
  std::vector<float> sorted = volume.samples;
  std::sort(sorted.begin(), sorted.end());
  return sorted[static_cast<std::size_t>(static_cast<double>(sorted.size()) * random.between(0.1, 0.9))];
}

// Samples as floats, and the isovalue.
struct Field {
  FloatVolume volume;
  double isovalue = 0.5;
};

Field floats(const Lattice& lattice, RandomNumbers& random) {
  Field field{noise(lattice, random)};
  field.isovalue = random_quantile(field.volume, random);
  return field;
}

Field mask(const Lattice& lattice, RandomNumbers& random) {
  Field field{noise(lattice, random)};
  const float threshold = random_quantile(field.volume, random);
  for (float& sample : field.volume.samples) sample = sample > threshold ? 1.0F : 0.0F;
  return field;
}

Field plateaus(const Lattice& lattice, RandomNumbers& random) {
  Field field{noise(lattice, random)};
  const int levels = 2 + random.below(5);
  for (float& sample : field.volume.samples)
    sample = std::min(std::floor(sample * static_cast<float>(levels)), static_cast<float>(levels - 1));
  field.isovalue = 1.0 + random.below(levels - 1) - (random.chance(0.3) ? 0.5 : 0.0);
  return field;
}

Field bytes_with_ties(const Lattice& lattice, RandomNumbers& random) {
  Field field{noise(lattice, random)};
  for (float& sample : field.volume.samples) sample = std::round(255.0F * sample);
  field.isovalue = random_quantile(field.volume, random);
  return field;
}

Field blocks_of_labels(const Lattice& lattice, RandomNumbers& random) {
  Field field{{lattice, std::vector<float>(lattice.nodes(), 0.0F)}};
  const int blocks = 2 + random.below(4);
  for (int block = 0; block < blocks; ++block) {
    std::array<int, 3> low{};
    std::array<int, 3> high{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = random.below(lattice.size[axis]);
      high[axis] = low[axis] + 1 + random.below(6);
    }
    const auto label = static_cast<float>(1 + random.below(3));
    for_each_node(field.volume, [&](int i, int j, int k, float& sample) {
      const bool within = i >= low[0] && i < high[0] && j >= low[1] && j < high[1] && k >= low[2] && k < high[2];
      if (within) sample = label;
    });
  }
  field.isovalue = random.chance(0.5) ? 0.5 : 1.0 + random.below(2);
  return field;
}

Field single_voxels(const Lattice& lattice, RandomNumbers& random) {
  Field field{{lattice, std::vector<float>(lattice.nodes())}};
  const double share = random.between(0.0, 0.5);
  for (float& sample : field.volume.samples) sample = random.chance(share) ? 1.0F : 0.0F;
  return field;
}

Field shell(const Lattice& lattice, RandomNumbers& random) {
  Field field{{lattice, std::vector<float>(lattice.nodes())}};
  const double radius = random.between(2.0, 6.0);
  const double thickness = random.between(0.8, 2.0);
  for_each_node(field.volume, [&](int i, int j, int k, float& sample) {
    const double r = std::hypot(i - lattice.size[0] / 2.0, j - lattice.size[1] / 2.0, k - lattice.size[2] / 2.0);
    sample = r > radius && r < radius + thickness ? 1.0F : 0.0F;
  });
  return field;
}

Field chessboard(const Lattice& lattice, RandomNumbers& random) {
  Field field{{lattice, std::vector<float>(lattice.nodes())}};
  const int side = 1 + random.below(6);
  for_each_node(field.volume, [&](int i, int j, int k, float& sample) {
    sample = static_cast<float>((i / side + j / side + k / side) % 2);
  });
  return field;
}

// Mostly zero, which may be the isovalue.
Field sparse(const Lattice& lattice, RandomNumbers& random) {
  Field field{noise(lattice, random)};
  const float threshold = random_quantile(field.volume, random);
  for (float& sample : field.volume.samples) sample = sample < threshold ? 0.0F : 1000.0F * (sample - 0.5F);
  field.isovalue = random.chance(0.5) ? 0.0 : 1.0;
  return field;
}

struct VolumeKind {
  const char* name;
  Field (*make)(const Lattice&, RandomNumbers&);
  bool whole_numbers;
};

constexpr std::array kinds = {VolumeKind{"floats", floats, false},
                              VolumeKind{"mask", mask, true},
                              VolumeKind{"plateaus", plateaus, true},
                              VolumeKind{"bytes with ties", bytes_with_ties, true},
                              VolumeKind{"blocks of labels", blocks_of_labels, true},
                              VolumeKind{"single voxels", single_voxels, true},
                              VolumeKind{"shell", shell, true},
                              VolumeKind{"chessboard", chessboard, true},
                              VolumeKind{"sparse", sparse, false}};

template <class T>
Samples convert(const std::vector<float>& samples) {
  return std::vector<T>(samples.begin(), samples.end());
}

using Conversion = Samples (*)(const std::vector<float>&);

// The first two hold every value, the others whole numbers from 0 to 255.
constexpr std::array<Conversion, 9> conversions = {
    convert<float>,        convert<double>,        convert<std::uint8_t>, convert<std::int16_t>, convert<std::uint16_t>,
    convert<std::int32_t>, convert<std::uint32_t>, convert<std::int64_t>, convert<std::uint64_t>};

}  // namespace

RandomVolume random_volume(RandomNumbers& random) {
  const VolumeKind& kind = kinds[static_cast<std::size_t>(random.below(static_cast<int>(kinds.size())))];
  Field field = kind.make(random_lattice(random), random);
  const int types = kind.whole_numbers ? static_cast<int>(conversions.size()) : 2;
  const Conversion into = conversions[static_cast<std::size_t>(random.below(types))];
  return {kind.name, {field.volume.lattice, into(field.volume.samples)}, field.isovalue};
}

}  // namespace isobench
