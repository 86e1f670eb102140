// Local feature size from shrinking balls (Ma, Bae, Choi 2012): the centres of the largest empty balls that touch the
// surface from either side approximate its medial axis.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

/// Points of the surface with their normals and curvatures (lattice frame, mm).
struct SurfaceSamples {
  std::vector<Eigen::Vector3d> points;   ///< within 1e-9 voxel of F = c, at least 0.1 voxel apart
  std::vector<Eigen::Vector3d> normals;  ///< outward, unit
  std::vector<Curvatures> curvature;     ///< 1/mm, capped at 2/voxel
  std::vector<double> slope;             ///< |∇f|
};

/// Projects candidates onto the surface and thins them. Candidates whose projection does not converge are left out.
SurfaceSamples surface_samples(const Isosurface& surface, const std::vector<Eigen::Vector3d>& candidates);

struct MedialBalls {
  std::vector<Eigen::Vector3d> centres;  ///< mm
  std::vector<double> radii;             ///< mm
};

/// One ball for each sample and side. A ball starts at a guess from the previous sample or at the osculating radius of
/// its side, if that is smaller. It doubles while it is empty and then shrinks until it is empty. The guess is small
/// because nearest-neighbour queries far from the surface are slow. `cap` (mm) bounds the radius. Balls that reach the
/// cap are kept, so no feature size exceeds it. The result does not depend on the number of threads.
MedialBalls shrinking_balls(const SurfaceSamples& samples, double voxel, double cap, Monitor& monitor);

/// λ: the distance to the nearest point of the medial axis. Many threads may call it at the same time.
class FeatureSize {
 public:
  /// The axis consists of the balls' centres, thinned to one in each cell of a twentieth of a voxel. λ is at most `cap`
  /// (mm), and equal to it where there is no axis.
  FeatureSize(const MedialBalls& balls, double voxel, double cap = std::numeric_limits<double>::infinity());
  ~FeatureSize();
  FeatureSize(FeatureSize&&) noexcept;
  double operator()(const Eigen::Vector3d& x) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace isobench
