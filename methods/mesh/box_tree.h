// Finds overlapping boxes: a tree over boxes in Morton order, with four children per node.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "isobench/methods/mesh/morton.h"

namespace isobench {

class BoxTree {
 public:
  using Index = std::uint32_t;
  using Box = Eigen::AlignedBox3d;

  /// Cost: O(n log n), dominated by the sort, which is parallel.
  explicit BoxTree(const std::vector<Box>& boxes) {
    std::vector<Eigen::Vector3d> centres(boxes.size());
    for (std::size_t n = 0; n < boxes.size(); ++n) centres[n] = boxes[n].center();
    order_ = morton_order(centres);
    levels_.emplace_back();
    for (const Index n : order_) levels_.front().push_back(boxes[n]);
    while (levels_.back().size() > 1) {
      const std::vector<Box>& below = levels_.back();
      std::vector<Box> level((below.size() + fan - 1) / fan);
      for (std::size_t n = 0; n < below.size(); ++n) level[n / fan].extend(below[n]);
      levels_.push_back(std::move(level));
    }
  }

  std::size_t size() const { return order_.size(); }

  /// Calls f(a, b) with the indices of two boxes that overlap or touch: a is the box at position `place` of the tree's
  /// order, b is at a later position. If this is called for all positions, each pair is visited once; the calls may run
  /// in parallel.
  template <typename Function>
  void overlapping_later(std::size_t place, Function&& f) const {
    descend(levels_.size() - 1, 0, place, f);
  }

  /// Whether a box of the tree overlaps or touches `box`.
  bool meets(const Box& box) const { return size() > 0 && meets(box, levels_.size() - 1, 0); }

 private:
  static constexpr std::size_t fan = 4;

  template <typename Function>
  void descend(std::size_t level, std::size_t node, std::size_t place, Function&& f) const {
    if (!levels_[level][node].intersects(levels_.front()[place])) return;
    if (level == 0) {
      if (node > place) f(order_[place], order_[node]);
      return;
    }
    const std::size_t end = std::min((node + 1) * fan, levels_[level - 1].size());
    // A node's leaves are the positions from node · fan^level on: skip children that end before `place`.
    for (std::size_t child = std::max(node * fan, place >> (2 * (level - 1))); child < end; ++child) {
      descend(level - 1, child, place, f);
    }
  }

  bool meets(const Box& box, std::size_t level, std::size_t node) const {
    if (!levels_[level][node].intersects(box)) return false;
    if (level == 0) return true;
    const std::size_t end = std::min((node + 1) * fan, levels_[level - 1].size());
    for (std::size_t child = node * fan; child < end; ++child) {
      if (meets(box, level - 1, child)) return true;
    }
    return false;
  }

  std::vector<Index> order_;              // by position: the index of the box
  std::vector<std::vector<Box>> levels_;  // the boxes, then the bounding boxes of `fan` boxes of the level before
};

}  // namespace isobench
