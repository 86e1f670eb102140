// Local feature size by shrinking balls (Ma, Bae, Choi 2012): the centres of the largest empty balls that touch the
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
  std::vector<Eigen::Vector3d> points;   ///< on F = c to 1e-9 voxel, no two nearer than 0.1 voxel
  std::vector<Eigen::Vector3d> normals;  ///< outward, unit
  std::vector<Curvatures> curvature;     ///< 1/mm, capped at 2/voxel
  std::vector<double> slope;             ///< |∇f|
};

/// Projects candidate points onto the surface and thins them; points that do not converge are left out.
SurfaceSamples surface_samples(const Isosurface& surface, const std::vector<Eigen::Vector3d>& candidates);

struct MedialBalls {
  std::vector<Eigen::Vector3d> centres;  ///< mm
  std::vector<double> radii;             ///< mm
};

/// One ball per sample and side. A ball starts at min(osculating radius of that side, a few voxels), doubles while it
/// is empty, and shrinks once it is not: queries from afar, where every sample is equally near, are what costs. `cap`
/// (mm) bounds the radius; balls that reach it are kept, so that no feature size exceeds the cap. Multi-threaded;
/// results do not depend on the number of threads.
MedialBalls shrinking_balls(const SurfaceSamples& samples, double voxel, double cap, Monitor& monitor);

/// λ: the distance to the nearest point of the medial axis. Built once, asked from many threads.
class FeatureSize {
 public:
  /// The balls' centres are the axis; they are thinned to one per cell of a twentieth of a voxel. No λ exceeds `cap`
  /// (mm), which is also the answer where there is no axis.
  FeatureSize(const MedialBalls& balls, double voxel, double cap = std::numeric_limits<double>::infinity());
  ~FeatureSize();
  FeatureSize(FeatureSize&&) noexcept;
  double operator()(const Eigen::Vector3d& x) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace isobench
