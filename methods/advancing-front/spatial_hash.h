// Finds edges or points by position: a hash of cells at several resolutions, so that long and short items both lie in
// cells of about their own size.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isobench::advancing_front {

/// Items are balls, named by small non-negative numbers.
class SpatialHash {
 public:
  /// `finest` (mm) is the size of the smallest cells; items may be smaller. Coordinates may be up to ±2¹⁸ such cells.
  explicit SpatialHash(double finest);

  /// Precondition: the item is not in the hash. The item is kept in a cell of at least four times its radius and at
  /// least twice the local `step` (mm), so that items shorter than the step are found with their neighbours.
  void insert(int item, const Eigen::Vector3d& centre, double radius, double step);
  /// Does nothing if the item is not in the hash.
  void erase(int item);

  /// Appends every item that may reach into the ball, and some that do not. Items whose step and diameter are both
  /// below `least` (mm) may be missing. The order depends only on the sequence of insertions and erasures.
  void near(const Eigen::Vector3d& centre, double radius, double least, std::vector<int>& found) const;

 private:
  struct Cell {
    std::uint64_t key = 0;
    int first = -1;
  };
  struct Link {
    int previous = -1;
    int next = -1;
    std::int64_t cell = -1;
    int level = 0;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  };

  double size_of(int level) const { return finest_ * static_cast<double>(std::uint64_t{1} << level); }
  Link& link(int item) { return links_[static_cast<std::size_t>(item)]; }
  const Link& link(int item) const { return links_[static_cast<std::size_t>(item)]; }
  std::size_t slot_of(std::uint64_t key) const;
  std::size_t slot_for(std::uint64_t key);
  void rehash();
  void near_in_level(int level, const Eigen::Vector3d& centre, double radius, std::vector<int>& found) const;

  static constexpr int levels = 24;
  double finest_;
  std::vector<Cell> cells_;
  std::size_t used_ = 0;
  std::vector<Link> links_;
  std::array<int, levels> items_in_level_{};
};

}  // namespace isobench::advancing_front
