// A triangle mesh whose points move on a surface and whose connectivity is kept Delaunay by edge flips. This is cheaper
// than triangulating space after every move, and sheets that are close to each other stay apart.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench::cvt {

class DelaunayMesh {
 public:
  /// An edge is flipped only if it has exactly two triangles with consistent orientation, and never into an edge that
  /// ends at a point with more than one fan. So borders and pinches stay as they are.
  DelaunayMesh(std::vector<Triangle> triangles, std::size_t points);

  const std::vector<Triangle>& triangles() const { return triangles_; }

  /// Flips edges until each is locally Delaunay, which means that the two angles opposite to it sum to at most π
  /// (Bobenko, Springborn 2007). Edges whose flip would create a second edge between two points, or a fold, stay.
  /// Returns the number of flips. Deterministic.
  std::size_t flip(const std::vector<Eigen::Vector3d>& points);

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  std::uint32_t corner(std::uint32_t half_edge) const { return triangles_[half_edge / 3][half_edge % 3]; }
  bool is_bad(const std::vector<Eigen::Vector3d>& points, std::uint32_t half_edge) const;
  bool may_flip(const std::vector<Eigen::Vector3d>& points, std::uint32_t half_edge) const;
  bool joined(std::uint32_t from, std::uint32_t to) const;
  void link(std::uint32_t a, std::uint32_t b);
  void flip_edge(std::uint32_t half_edge);

  // Half-edge 3t + k is the edge of triangle t opposite its corner k, with the triangle on its left.
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> across_;  // the opposite half-edge; none if the edge must stay
  std::vector<char> pinched_;
};

}  // namespace isobench::cvt
