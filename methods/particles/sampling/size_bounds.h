// Upper bounds on h around points where the sizing field is too large. The field is interpolated between nodes one
// voxel apart, so it cannot follow features smaller than a voxel; and some sizes turn out too large only when the
// particles are triangulated.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <unordered_map>
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

  /// Time and memory are linear in the number of bounds. The first bound takes 4 bytes for each block of 4 × 4 × 4
  /// voxels, and so does the first bound of each order of magnitude that reaches farther than such a block is wide.
  void add(const std::vector<SizeBound>& bounds);

  std::size_t size() const { return bounds_.size(); }
  const SizeBound& at(std::size_t n) const { return bounds_[n]; }
  /// The bound n on h at x, mm; infinite beyond its reach.
  double bound(std::size_t n, const Eigen::Vector3d& x) const;
  /// The smallest bound on h at x, mm; infinite where there is none.
  double bound(const Eigen::Vector3d& x) const;
  /// The least distance from x to the position of a bound that reaches x, divided by that bound's scale. Only bounds
  /// with an index of at least `first` count. Infinite where none reaches x.
  double scaled_distance(const Eigen::Vector3d& x, std::size_t first) const;
  /// The bounds that reach x, in order.
  std::vector<std::uint32_t> reaching(const Eigen::Vector3d& x) const;
  /// The bounds that reach a box, in order. Time is linear in the number of bounds.
  std::vector<std::uint32_t> reaching(const Eigen::AlignedBox3d& box) const;

 private:
  /// A bound in a list: what most visits need, beside each other in memory.
  struct Listed {
    Eigen::Vector3d position;
    double h;
    double plateau;
    double reach;
    std::uint32_t number;
  };
  using List = std::vector<Listed>;  // in increasing order of h

  /// Bounds of one order of magnitude, listed by bricks at least as wide as the farthest reach among them. Wide bricks
  /// are few, so each has a number; narrow ones may be thousands to a voxel, but only those at bounds are kept.
  struct Grid {
    double brick = 0.0;  // mm
    Eigen::Array3i bricks;
    bool is_narrow = false;
    std::vector<std::int32_t> list_of_brick;  // of a wide grid; -1: no bound reaches into the brick
    std::unordered_map<std::uint64_t, std::int32_t> list_of_narrow_brick;
    std::vector<List> lists;

    std::uint64_t brick_of(const Eigen::Vector3d& x) const;
    std::int32_t list_at(const Eigen::Vector3d& x) const;  ///< -1: no bound reaches x
    List& list_for(std::uint64_t at);
    /// The numbers of the bricks into which a bound at this position may reach.
    std::vector<std::uint64_t> bricks_around(const Eigen::Vector3d& position, const Eigen::Vector3d& extent) const;
  };

  Grid& grid_for(double reach);
  void mark_blocks(const Eigen::Vector3d& position, double reach, std::uint32_t mark);
  /// Calls visit(list) for the lists of bounds that may reach x.
  template <class Visit>
  void visit_lists(const Eigen::Vector3d& x, Visit&& visit) const;
  /// Calls visit(number) for the bounds that reach x.
  template <class Visit>
  void visit_reaching(const Eigen::Vector3d& x, Visit&& visit) const;

  double delta_;
  double voxel_;
  Eigen::Vector3d extent_;
  std::vector<SizeBound> bounds_;
  std::vector<Grid> grids_;
  Eigen::Array3i blocks_;
  std::vector<std::uint32_t> grids_at_block_;  // bit n: a bound of the narrow grid n may reach into the block
};

}  // namespace isobench::particles
