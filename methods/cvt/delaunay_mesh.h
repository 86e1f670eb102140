// The connectivity of points that move on a surface, kept Delaunay by edge flips: cheaper than a triangulation of space
// for every move, and sheets that lie close to each other stay apart.
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
  /// Edges that do not have exactly two triangles of opposite turns are never flipped, nor is an edge made that ends at
  /// a point with more than one fan: pinches and rims stay as they are.
  DelaunayMesh(std::vector<Triangle> triangles, std::size_t points);

  const std::vector<Triangle>& triangles() const { return triangles_; }

  /// Flips edges until each is locally Delaunay (the two angles opposite to it sum up to at most π; Bobenko, Springborn
  /// 2007) or could only be flipped into an edge that exists or a fold. Returns how many were flipped. Deterministic.
  std::size_t flip(const std::vector<Eigen::Vector3d>& points);

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  std::uint32_t corner(std::uint32_t half_edge) const { return triangles_[half_edge / 3][half_edge % 3]; }
  bool is_bad(const std::vector<Eigen::Vector3d>& points, std::uint32_t half_edge) const;
  bool may_flip(const std::vector<Eigen::Vector3d>& points, std::uint32_t half_edge) const;
  bool joined(std::uint32_t from, std::uint32_t to) const;
  void link(std::uint32_t a, std::uint32_t b);
  void flip_edge(std::uint32_t half_edge);

  // A half-edge 3t + k is the edge of triangle t opposite its corner k, with the triangle on its left.
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> across_;  // the other half of each half-edge; none where it must stay
  std::vector<char> pinched_;
};

}  // namespace isobench::cvt
