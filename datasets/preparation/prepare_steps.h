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

void fill_outside(Volume& volume, const FillOutside& step, Monitor& monitor);
/// The value that FillOutside sets. Throws DataError if no sample is finite.
double value_outside(const Volume& volume, const FillOutside& step);

// Steps that compute with real numbers.

/// Felzenszwalb & Huttenlocher, Distance transforms of sampled functions (2012): one lower envelope of parabolas for
/// each row and axis. Distances inside and outside share one array; the sign tells them apart.
FloatVolume signed_distance(Volume volume, Monitor& monitor);
/// These are compiled for float and for double.
template <class Real>
void gaussian(RealVolume<Real>& volume, const Eigen::Vector3d& sigma, Monitor& monitor);
template <class Real>
RealVolume<Real> resample(const RealVolume<Real>& volume, const Eigen::Vector3d& spacing);
template <class Real>
RealVolume<Real> subsample(const RealVolume<Real>& volume, int factor);
template <class Real>
RealVolume<Real> rectangular(const RealVolume<Real>& volume, double outside, Monitor& monitor);

/// Throws DataError unless a volume of this size can be made.
void check_size(const std::array<int, 3>& size);

}  // namespace isobench
