// Preparing a volume: the steps that a manifest chains. Sigma and padding are in voxels, because they are about
// samples; distances are in mm.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "isobench/datasets/volume.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

/// 1 where sample ≥ at, else 0. Integer samples are compared exactly, whatever their size.
struct Threshold {
  double at = 0.5;
};
/// 1 where the sample is one of the labels, else 0. Samples and labels are compared exactly, as integers of up to 64
/// bits.
struct SelectLabels {
  std::vector<std::int64_t> labels;
};
/// Keeps the largest component of the nodes > 0, where the 26 nodes around a node are its neighbours; all other nodes
/// become 0.
struct LargestComponent {};
/// Cuts the volume to the bounding box of the nodes > 0 and a margin around it, as far as the volume reaches.
struct Crop {
  int margin = 0;  ///< voxels
};
/// Adds layers of one value on all sides.
struct Pad {
  int voxels = 4;
  double value = 0.0;
};
/// Interpolates linearly at the spacing (mm) that is nearest to this one and keeps the first and the last node in
/// place.
struct Resample {
  Eigen::Vector3d spacing;
};
/// The exact Euclidean distance in mm from each node > 0 to the nearest other node (positive), and from each other node
/// to the nearest node > 0 (negative). Distances are from node to node: no sample is 0, neighbours on two sides of the
/// border have ± their spacing, and the border lies half a voxel from both.
struct SignedDistance {};
/// Smooths with a Gaussian, truncated at 4 sigma. The outermost samples are repeated beyond the border.
struct Gaussian {
  Eigen::Vector3d sigma;  ///< voxels along each axis
};
/// Closes an object that reaches the volume's border, outside the volume, so that every slice counts with its whole
/// thickness. Each side on which a node of the two outermost layers is inside the object gets three more layers of one
/// value. It is as far outside the object as the median of those nodes is inside, and at least a tenth of the samples'
/// range, for a steep surface: F = c then closes about half a voxel beyond the outermost nodes. Integer samples stay
/// integers where they can hold a value that is as far outside or farther. The monitor gets a note with the area that
/// was closed. Does nothing if no such node is inside.
struct CloseBorder {
  double isovalue = 0.0;
  bool object_below = false;  ///< the object is where values are below the isovalue
};
/// Replaces samples that say nothing, NaN and infinity away from the object, by a value outside the object: the one
/// farthest outside that the volume has, and at least a tenth of the samples' range away from c. The monitor gets a
/// note with their number. Throws DataError naming the node if a sample is infinite on the object's side.
struct FillOutside {
  double isovalue = 0.0;
  bool object_below = false;
};
/// Samples a volume whose axes are not perpendicular (a tilted gantry) on perpendicular ones, linearly: i stays, j and
/// k become perpendicular to it and to each other, with the same number of nodes to a length. Slices whose i and j are
/// perpendicular stay where they are, so that each is only shifted in its plane. The box holds all old nodes; what lies
/// beyond them is outside the object, as FillOutside sets it. The monitor gets a note.
struct Rectangular {
  double isovalue = 0.0;
  bool object_below = false;
};
/// The mean of each block of factor³ nodes, placed at the block's middle. Nodes that do not fill a block at the far
/// ends are dropped.
struct Subsample {
  int factor = 2;
};
/// Keeps the block of `size` nodes that begins at node `from`.
struct Cut {
  std::array<int, 3> from{0, 0, 0};  ///< the first node along i, j, k; they count from 0
  std::array<int, 3> size{1, 1, 1};  ///< nodes
};
using PrepareStep = std::variant<Threshold, SelectLabels, LargestComponent, Crop, Pad, Resample, SignedDistance,
                                 Gaussian, CloseBorder, Subsample, Cut, FillOutside, Rectangular>;

/// One line for a log or a record, e.g. "gaussian sigma = (1.5, 1.5, 1.5) voxels".
std::string describe(const PrepareStep& step);

/// Applies the steps in order; nodes keep their place in the world. Threshold and SelectLabels give bytes,
/// SignedDistance gives floats. Resample, Gaussian, Subsample and Rectangular give floats, or doubles if some sample is
/// none that a float can hold. The other steps keep the type of the samples, unless this type cannot hold a value that
/// they set: then it becomes RealOf the type. Throws DataError if a step leaves nothing (an empty crop, a threshold
/// that no sample reaches) or cannot be done (a distance in a volume that is all inside, a cut beyond the volume).
/// Time: linear in the nodes for every step. Memory: at most the samples before and after one step. Resample,
/// SignedDistance, Gaussian and Subsample are threaded and give the same bits with any number of threads.
Volume prepare(Volume volume, const std::vector<PrepareStep>& steps, Monitor& monitor);

}  // namespace isobench
