// The lattice nodes near the surface, stored sparsely: cells that the surface crosses plus two nodes all round.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "isobench/datasets/isosurface.h"

namespace isobench {

/// A set of lattice nodes with consecutive numbers. Nodes are kept in bricks of 4³, one 64-bit mask a brick, so that a
/// node's number is the brick's offset plus a population count; memory is 16 bytes a brick plus what is stored per
/// node.
class Band {
 public:
  /// Every node within `margin` nodes (along each axis) of a cell whose corners differ in sign; one pass over the
  /// lattice. `margin` = 0 gives the corners of the crossed cells alone.
  Band(const Isosurface& surface, int margin);

  std::size_t size() const { return nodes_.size(); }
  /// Lattice indices of node n; order: brick by brick, x fastest within one.
  const std::array<int, 3>& node(std::size_t n) const { return nodes_[n]; }
  /// Number of a node, -1 if it is not in the band or not in the lattice.
  std::int32_t find(int i, int j, int k) const;
  Eigen::Vector3d position(std::size_t n) const;
  const Eigen::Vector3d& spacing() const { return spacing_; }

  /// Trilinear interpolation of node values at x (lattice frame, mm). Nodes outside the band are left out and the
  /// weights of the others rescaled; std::nullopt where none of the eight is in the band.
  std::optional<double> interpolate(const std::vector<float>& values, const Eigen::Vector3d& x) const;

 private:
  void list_nodes();  // numbers the nodes marked in mask_

  std::array<int, 3> size_{};
  std::array<int, 3> bricks_{};
  Eigen::Vector3d spacing_;
  std::vector<std::uint64_t> mask_;
  std::vector<std::int32_t> offset_;
  std::vector<std::array<int, 3>> nodes_;
};

}  // namespace isobench
