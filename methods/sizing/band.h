// The lattice nodes near the surface, stored sparsely.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "isobench/datasets/isosurface.h"

namespace isobench {

/// A set of lattice nodes with consecutive numbers. Nodes are stored in bricks of 4³ with one 64-bit mask per brick, so
/// a node's number is the brick's offset plus a population count. Memory: 12 bytes a brick and 12 bytes a node.
class Band {
 public:
  /// All nodes within `margin` nodes, along each axis, of a cell whose corners differ in sign. `margin` = 0 gives only
  /// the corners of these cells. Cost: one pass over the lattice.
  Band(const Isosurface& surface, int margin);

  std::size_t size() const { return nodes_.size(); }
  /// Lattice indices of node n. Nodes are ordered by brick, and within a brick with x fastest.
  const std::array<int, 3>& node(std::size_t n) const { return nodes_[n]; }
  /// The number of a node; −1 if it is not in the band or not in the lattice.
  std::int32_t find(int i, int j, int k) const;
  Eigen::Vector3d position(std::size_t n) const;
  const Eigen::Vector3d& spacing() const { return spacing_; }

  /// Trilinear interpolation of node values at x (lattice frame, mm). Nodes outside the band are left out, and the
  /// weights of the others are rescaled. Returns std::nullopt where none of the eight nodes is in the band.
  std::optional<double> interpolate(const std::vector<float>& values, const Eigen::Vector3d& x) const;

 private:
  void list_nodes();  // fills offset_ and nodes_ from mask_

  std::array<int, 3> size_{};
  std::array<int, 3> bricks_{};
  Eigen::Vector3d spacing_;
  std::vector<std::uint64_t> mask_;
  std::vector<std::int32_t> offset_;
  std::vector<std::array<int, 3>> nodes_;
};

}  // namespace isobench
