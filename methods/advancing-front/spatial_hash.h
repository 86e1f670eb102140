// Where edges or points are: a hash of cells in several resolutions, so that what is long and what is short both lie in
// cells of about the size of their neighbourhood.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isobench::advancing_front {

/// Items are named by small numbers, each at most once; an item is kept as a ball.
class SpatialHash {
 public:
  /// `finest` (mm) is the size of the smallest cells; items may be smaller. Coordinates up to 2¹⁸ cells either way.
  explicit SpatialHash(double finest);

  /// The item must not be in the hash. It goes into cells of four times its radius or twice the `step` (mm) there,
  /// whichever is larger, so that small items lie with their neighbours.
  void insert(int item, const Eigen::Vector3d& centre, double radius, double step);
  /// Does nothing if the item is not in the hash.
  void erase(int item);

  /// Appends every item that may reach into the ball, and a few that do not; items where both the step and their
  /// diameter are below `least` (mm) may be left out. The order depends only on what was inserted and erased, and when.
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
