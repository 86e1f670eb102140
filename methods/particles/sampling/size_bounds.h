// Where particles must stand closer than the sizing field can say: a lattice of nodes one voxel apart cannot show sizes
// that fall within a voxel, nor can those that only the triangulation of the particles finds too large.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "isobench/datasets/isosurface.h"

namespace isobench::particles {

/// mm throughout, positions in the lattice frame.
struct SizeBound {
  Eigen::Vector3d position;
  double edge = 0.0;  ///< h there
  double flat = 0.0;  ///< how far around it h is bounded by the same
  double unit = 0.0;  ///< what the farther rise goes by
};

/// An upper bound on h around places. Beyond a place's flat part it rises by δ a mm and, after a unit, more than that,
/// so that nothing is bounded from four units on.
class SizeBounds {
 public:
  SizeBounds(const Isosurface& surface, double delta);

  /// Time and memory linear in the places; the first one of a new order of size also takes 4 bytes per brick of four
  /// voxels, or more, a side.
  void add(const std::vector<SizeBound>& places);

  std::size_t size() const { return places_.size(); }
  const SizeBound& at(std::size_t n) const { return places_[n]; }
  /// mm; infinite where nothing is bounded.
  double bound(const Eigen::Vector3d& x) const;
  /// The least distance to one of the places from number `first` on, each in its own units; infinite where none bounds.
  double units_from(const Eigen::Vector3d& x, std::size_t first) const;

 private:
  /// Places of one order of size, by bricks at least as wide as any of them reaches.
  struct Level {
    double brick = 0.0;  // mm
    Eigen::Array3i bricks;
    std::vector<std::int32_t> list_of_brick;  // -1: none reaches into it
    std::vector<std::vector<std::uint32_t>> lists;

    std::size_t brick_of(const Eigen::Vector3d& x) const;
    void add(std::uint32_t place, const Eigen::Vector3d& position, const Eigen::Vector3d& extent);
  };

  Level& level_for(double reach);
  template <class Visit>
  void visit_near(const Eigen::Vector3d& x, Visit&& visit) const;

  double delta_;
  double voxel_;
  Eigen::Vector3d extent_;
  std::vector<SizeBound> places_;
  std::vector<Level> levels_;
};

}  // namespace isobench::particles
