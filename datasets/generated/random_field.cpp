#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>

#include "isobench/datasets/generated/generators.h"
#include "isobench/datasets/preparation/prepare_steps.h"
#include "isobench/foundation/random.h"

namespace isobench {

namespace {

constexpr int fade_layers = 4;  // from the border's outside layers to where the field is whole

/// White noise of variance 1/3, smoothed, on the lattice and `margin` nodes around it, so that the repeated samples
/// beyond the border do not matter within.
FloatVolume smooth_noise(const GeneratedRequest& request, int margin, Monitor& monitor) {
  GeneratedRequest larger = request;
  for (int& count : larger.size) count += 2 * margin;
  Lattice lattice;
  lattice.size = larger.size;
  FloatVolume noise = sampled(larger, [&](const Eigen::Vector3d& voxel) {
    const Eigen::Vector3i node = voxel.cast<int>();
    return 2.0 * uniform_random(request.seed, lattice.index(node[0], node[1], node[2]), 0) - 1.0;
  });
  gaussian(noise, Eigen::Vector3d::Constant(request.correlation), monitor);
  return noise;
}

FloatVolume without_margin(const FloatVolume& larger, int margin, const GeneratedRequest& request) {
  return sampled(request, [&](const Eigen::Vector3d& voxel) {
    const Eigen::Vector3i node = (voxel.cast<int>().array() + margin).matrix();
    return larger.at(node[0], node[1], node[2]);
  });
}

/// Mean 0 and standard deviation 1. Sums run in the order of the samples, so that threads make no difference.
void standardise(std::vector<float>& samples) {
  const auto count = static_cast<double>(samples.size());
  double mean = 0.0;
  for (const float sample : samples) mean += sample;
  mean /= count;
  double variance = 0.0;
  for (const float sample : samples) variance += (sample - mean) * (sample - mean);
  const double scale = 1.0 / std::sqrt(variance / count);
  for (float& sample : samples) sample = static_cast<float>((sample - mean) * scale);
}

/// 0 on the outermost layers, 1 where the field is whole, and smooth in between.
double weight_at(int node, int count) {
  const int layer = std::min(node, count - 1 - node);
  const double t = std::clamp((layer - generated_border + 1.0) / (fade_layers + 1.0), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double fade_weight(const Eigen::Vector3d& voxel, const std::array<int, 3>& size) {
  double weight = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    weight *= weight_at(static_cast<int>(voxel[static_cast<int>(axis)]), size[axis]);
  return weight;
}

/// The value below which this share of the values lies, halfway between two of them. There are at least two.
double quantile_of(std::vector<float> values, double share) {
  const auto count = static_cast<std::ptrdiff_t>(values.size());
  const std::ptrdiff_t below = std::clamp<std::ptrdiff_t>(std::llround(share * count), 1, count - 1);
  std::nth_element(values.begin(), values.begin() + below, values.end());
  const float above = values[static_cast<std::size_t>(below)];
  return 0.5 * (static_cast<double>(*std::max_element(values.begin(), values.begin() + below)) + above);
}

}  // namespace

RandomField random_field(const GeneratedRequest& request, Monitor& monitor) {
  const int margin = static_cast<int>(std::lround(4.0 * request.correlation));  // the radius of the Gaussian
  RandomField result{without_margin(smooth_noise(request, margin, monitor), margin, request)};
  FloatVolume& field = result.field;
  standardise(field.samples);
  const FloatVolume weights =
      sampled(request, [&](const Eigen::Vector3d& voxel) { return fade_weight(voxel, request.size); });
  std::vector<float> whole;
  for (std::size_t n = 0; n < field.samples.size(); ++n) {
    if (weights.samples[n] == 1.0F) whole.push_back(field.samples[n]);
  }
  result.isovalue = quantile_of(std::move(whole), request.quantile);
  const double outside = result.isovalue - 1.0;
  for (std::size_t n = 0; n < field.samples.size(); ++n) {
    field.samples[n] = static_cast<float>(outside + weights.samples[n] * (field.samples[n] - outside));
  }
  return result;
}

Volume random_mask(const GeneratedRequest& request, Monitor& monitor) {
  const RandomField random = random_field(request, monitor);
  std::vector<std::uint8_t> labels(random.field.samples.size());
  std::transform(random.field.samples.begin(), random.field.samples.end(), labels.begin(),
                 [&](float sample) -> std::uint8_t { return sample > random.isovalue ? 1 : 0; });
  return {random.field.lattice, std::move(labels)};
}

}  // namespace isobench
