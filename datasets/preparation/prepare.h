// Preparing a volume: the steps that a manifest chains. Each is a free function on volumes; lengths of sigma and
// padding are in voxels because the preparation is of samples, distances in mm.
#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

#include "isobench/datasets/volume.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

/// 1 where sample ≥ at, else 0.
struct Threshold {
  double at = 0.5;
};
/// 1 where the sample is one of the labels, else 0.
struct SelectLabels {
  std::vector<int> labels;
};
/// Of the nodes > 0, 26-connected; the others become 0.
struct LargestComponent {};
/// To the bounding box of the nodes > 0 and a margin around it, as far as the volume reaches; the origin moves along.
struct Crop {
  int margin = 0;  ///< voxels
};
/// Constant layers all round; the origin moves along.
struct Pad {
  int voxels = 4;
  double value = 0.0;
};
/// Linear, to the spacing (mm) nearest to this with which the first and the last node keep their places.
struct Resample {
  Eigen::Vector3d spacing;
};
/// Exact Euclidean distance in mm from each node > 0 to the nearest node that is not (positive), and the other way
/// round (negative). From node to node: there is no 0, neighbours across the border have ± their spacing, and the
/// border lies half a voxel from both.
struct SignedDistance {};
/// Sigma in voxels along each axis, truncated at 4 sigma; beyond the border the outermost samples are repeated.
struct Gaussian {
  Eigen::Vector3d sigma;
};
/// Makes the outermost layers outside the object, so that no surface leaves the volume. They become the volume's
/// minimum or, with `use_minimum` false, are clamped to at most `value`; with `object_below` maximum and at least
/// `value`.
struct CloseBorder {
  double value = 0.0;
  bool use_minimum = true;
  int layers = 2;
  bool object_below = false;
};
/// The mean of each block of factor³ nodes, placed at its middle; what is left over at the far ends is dropped.
struct Subsample {
  int factor = 2;
};
using PrepareStep = std::variant<Threshold, SelectLabels, LargestComponent, Crop, Pad, Resample, SignedDistance,
                                 Gaussian, CloseBorder, Subsample>;

/// One line for a log or a record, e.g. "gaussian sigma = (1.5, 1.5, 1.5) voxels".
std::string describe(const PrepareStep& step);

/// Applies the steps in order, in place where the size stays. Throws DataError where a step leaves nothing (an empty
/// crop, a threshold nothing reaches) or cannot be done (a distance in a volume that is all inside). Cost: linear in
/// the nodes for every step; all are threaded except those of microseconds a slice.
Volume prepare(Volume volume, const std::vector<PrepareStep>& steps, Monitor& monitor);

}  // namespace isobench
