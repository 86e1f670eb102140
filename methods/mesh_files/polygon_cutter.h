// Cuts a polygon in space into triangles: ear clipping (Meisters 1975) in the plane of its Newell normal. Of all ears
// the one with the best shape goes first, and the last four corners get the better diagonal.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

/// Keeps its memory from one polygon to the next.
class PolygonCutter {
 public:
  /// Makes points.size() − 2 triangles, turned as the polygon is. A simple polygon in a plane, convex or not, is
  /// covered exactly. Returns false if it crosses itself or has no area: its triangles may then overlap. Precondition:
  /// at least three points. Cost: n corners of which r are not convex take O(n² + n r).
  bool cut(std::span<const Eigen::Vector3d> points);
  /// Of the last call; corners are indices into its points.
  const std::vector<Triangle>& triangles() const { return triangles_; }

 private:
  using Index = std::uint32_t;
  static constexpr Index none = std::numeric_limits<Index>::max();

  bool project(std::span<const Eigen::Vector3d> points);
  void fan(std::size_t count);
  double turn(Index a, Index b, Index c) const;
  double shape(Index a, Index b, Index c) const;
  bool is_near(Index a, Index b) const { return (plane_[a] - plane_[b]).squaredNorm() <= gap_ * gap_; }
  bool beside(Index from, Index to, Index p) const;
  void update(Index corner);
  void update_all();
  Index blocker_of(Index ear) const;
  Index best_ear();
  void clip(Index ear);

  std::vector<Triangle> triangles_;
  std::vector<Eigen::Vector2d> plane_;
  std::vector<Index> next_, previous_;
  std::vector<Index> left_;     // corners that are not yet clipped, in any order
  std::vector<Index> place_;    // of a corner in left_; none if it is clipped
  std::vector<char> convex_;    // by more than gap_
  std::vector<double> shape_;   // of each corner's ear
  std::vector<Index> blocker_;  // a corner that was found within the ear
  double gap_ = 0.0;            // mm; corners nearer than this to a line count as on it
};

}  // namespace isobench
