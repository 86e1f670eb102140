// The longer preparing steps, one file each, behind prepare(); see there for what they do.
#pragma once

#include "isobench/datasets/preparation/prepare.h"
#include "isobench/datasets/volume.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

/// Felzenszwalb & Huttenlocher, Distance transforms of sampled functions (2012): one lower envelope of parabolas a row
/// and axis, here for inside and outside in one array, told apart by sign.
void signed_distance(Volume& volume, Monitor& monitor);
void gaussian(Volume& volume, const Eigen::Vector3d& sigma, Monitor& monitor);
/// Unites runs of nodes along x, so that it costs little more than reading the volume once.
void keep_largest_component(Volume& volume);
void resample(Volume& volume, const Eigen::Vector3d& spacing);
void subsample(Volume& volume, int factor);
void crop(Volume& volume, int margin);
void pad(Volume& volume, int voxels, float value);
void close_border(Volume& volume, const CloseBorder& step);

}  // namespace isobench
