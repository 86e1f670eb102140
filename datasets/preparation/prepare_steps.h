// The functions behind prepare(); prepare.h says what each step does.
#pragma once

#include "isobench/datasets/preparation/prepare.h"
#include "isobench/datasets/volume.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

// Steps that keep the type of the samples, or give bytes.

/// 1 where selected, 0 elsewhere, as u8. Compares in the samples' own type.
void threshold(Volume& volume, double at);
void select_labels(Volume& volume, const std::vector<std::int64_t>& labels);
/// Unites runs of nodes along x, so that it costs little more than reading the volume once.
void keep_largest_component(Volume& volume);
void crop(Volume& volume, int margin);
void cut(Volume& volume, const Cut& step);
/// These two give RealOf the samples' type if that type cannot hold the value.
void pad(Volume& volume, int voxels, double value);
void close_border(Volume& volume, const CloseBorder& step, Monitor& monitor);

// Steps that compute with floats.

/// Felzenszwalb & Huttenlocher, Distance transforms of sampled functions (2012): one lower envelope of parabolas for
/// each row and axis. Distances inside and outside share one array; the sign tells them apart.
FloatVolume signed_distance(Volume volume, Monitor& monitor);
void gaussian(FloatVolume& volume, const Eigen::Vector3d& sigma, Monitor& monitor);
FloatVolume resample(const FloatVolume& volume, const Eigen::Vector3d& spacing);
FloatVolume subsample(const FloatVolume& volume, int factor);

/// Throws DataError unless a volume of this size can be made.
void check_size(const std::array<int, 3>& size);

}  // namespace isobench
