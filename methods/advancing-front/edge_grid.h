// Where the edges of a front are: a hash of cells in several resolutions, so that long and short edges both lie in
// cells of about their own length.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isobench::advancing_front {

/// Edges are named by small numbers, each at most once; only midpoints and lengths are kept.
class EdgeGrid {
 public:
  /// `finest` (mm) is the size of the smallest cells; edges may be shorter. Coordinates up to 2¹⁸ cells either way.
  explicit EdgeGrid(double finest);

  /// The edge must not be in the grid.
  void insert(int edge, const Eigen::Vector3d& from, const Eigen::Vector3d& to);
  /// Does nothing if the edge is not in the grid.
  void erase(int edge);

  /// Appends every edge that may reach into the ball, and a few that do not; edges in cells less than `least` (mm) in
  /// size are left out. The order depends only on what was inserted and erased, and when.
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
  };

  double size_of(int level) const { return finest_ * static_cast<double>(std::uint64_t{1} << level); }
  std::size_t slot_of(std::uint64_t key) const;
  std::size_t slot_for(std::uint64_t key);
  void rehash();

  static constexpr int levels = 24;
  double finest_;
  std::vector<Cell> cells_;
  std::size_t used_ = 0;
  std::vector<Link> links_;
  std::array<int, levels> edges_in_level_{};
};

}  // namespace isobench::advancing_front
