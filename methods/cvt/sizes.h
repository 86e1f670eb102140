// How far apart sites shall be: the sizing asked for, and less where the topology of the surface wants more sites.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "methods/particles/seeds.h"

namespace isobench::cvt {

class Sizes {
 public:
  /// Keeps a reference.
  explicit Sizes(const particles::Spacing& spacing) : spacing_(spacing) {}

  /// mm, > 0. Time: the field's, and a few distances near refined places.
  double operator()(const Eigen::Vector3d& x) const;

  /// Within 1.2 of what it is now sizes shrink to 0.7 of it around each of these, and grow from there with slope 0.3.
  /// Without this a tessellation evens out again what was added to it.
  void refine(const std::vector<Eigen::Vector3d>& centres);

 private:
  struct Ball {
    Eigen::Vector3d centre;
    double radius;  // within which
    double size;    // is at most this
    double reach;   // beyond which it has no effect
  };
  using Cell = std::array<std::int32_t, 3>;
  struct CellHash {
    std::size_t operator()(const Cell& cell) const;
  };
  Cell cell_of(const Eigen::Vector3d& x) const;

  const particles::Spacing& spacing_;
  std::vector<Ball> balls_;
  double width_ = 1.0;                                                   // of cells
  std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> near_;  // balls that reach into a cell
};

}  // namespace isobench::cvt
