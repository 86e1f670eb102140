// Upper bounds on h around points where the sizing field is too large. The field is interpolated between nodes one
// voxel apart, so it cannot follow features smaller than a voxel; and some sizes turn out too large only when the
// particles are triangulated.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "isobench/datasets/isosurface.h"

namespace isobench::particles {

/// The bound on h around one point. Lengths in mm, the position in the lattice frame.
struct SizeBound {
  Eigen::Vector3d position;
  double h = 0.0;        ///< the bound at the position
  double plateau = 0.0;  ///< radius within which the bound stays the same
  double scale = 0.0;    ///< beyond the plateau, the bound rises by δ per mm for this length, then faster
};

/// All bounds on one surface; the smallest bound at a point holds. A bound ends at a distance of four times its scale
/// from its plateau.
class SizeBounds {
 public:
  /// `delta` is δ, the rise of a bound beyond its plateau in mm per mm.
  SizeBounds(const Isosurface& surface, double delta);

  /// Time and memory are linear in the number of bounds. The first bound of a new order of magnitude also takes 4 bytes
  /// for each brick of its grid; a brick is at least four voxels wide.
  void add(const std::vector<SizeBound>& bounds);

  std::size_t size() const { return bounds_.size(); }
  const SizeBound& at(std::size_t n) const { return bounds_[n]; }
  /// The smallest bound on h at x, mm; infinite where there is none.
  double bound(const Eigen::Vector3d& x) const;
  /// The least distance from x to the position of a bound that reaches x, divided by that bound's scale. Only bounds
  /// with an index of at least `first` count. Infinite where none reaches x.
  double scaled_distance(const Eigen::Vector3d& x, std::size_t first) const;

 private:
  /// Bounds of one order of magnitude, listed by bricks at least as wide as the farthest reach among them.
  struct Grid {
    double brick = 0.0;  // mm
    Eigen::Array3i bricks;
    std::vector<std::int32_t> list_of_brick;  // -1: no bound reaches into the brick
    std::vector<std::vector<std::uint32_t>> lists;

    std::size_t brick_of(const Eigen::Vector3d& x) const;
    void add(std::uint32_t bound, const Eigen::Vector3d& position, const Eigen::Vector3d& extent);
  };

  Grid& grid_for(double reach);
  template <class Visit>
  void visit_near(const Eigen::Vector3d& x, Visit&& visit) const;

  double delta_;
  double voxel_;
  Eigen::Vector3d extent_;
  std::vector<SizeBound> bounds_;
  std::vector<Grid> grids_;
};

}  // namespace isobench::particles
