// Nearest-neighbour search among points, by a kd-tree of nanoflann.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <limits>
#include <nanoflann.hpp>
#include <utility>
#include <vector>

namespace isobench {

class PointTree {
 public:
  /// Keeps a reference to the points: they must outlive the tree and must not change.
  explicit PointTree(const std::vector<Eigen::Vector3d>& points)
      : adaptor_{points}, index_(3, adaptor_, nanoflann::KDTreeSingleIndexAdaptorParams(12)) {
    index_.buildIndex();
  }
  PointTree(const PointTree&) = delete;
  PointTree& operator=(const PointTree&) = delete;

  /// The index of the point nearest to x, and the distance to it.
  std::pair<std::size_t, double> nearest(const Eigen::Vector3d& x) const {
    return nearest(x, 0, std::numeric_limits<double>::max());
  }
  /// The same, starting from point `guess`: the nearer it is to x, the faster the search.
  std::pair<std::size_t, double> nearest(const Eigen::Vector3d& x, std::size_t guess) const {
    return nearest(x, guess, (adaptor_.points[guess] - x).squaredNorm());
  }

 private:
  struct Adaptor {
    const std::vector<Eigen::Vector3d>& points;
    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::size_t n, std::size_t axis) const { return points[n][static_cast<Eigen::Index>(axis)]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
      return false;
    }
  };
  using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Adaptor>, Adaptor, 3>;

  /// A result set for nanoflann: keeps the nearest point with a squared distance below `square`. nanoflann's own result
  /// sets take such a bound in some versions only.
  struct Nearest {
    using DistanceType = double;
    std::size_t index;
    double square;
    double worstDist() const { return square; }  // NOLINT(readability-identifier-naming): the library's name
    bool full() const { return true; }
    void sort() const {}
    bool addPoint(double found, std::size_t at) {  // NOLINT(readability-identifier-naming): the library's name
      if (found < square) {
        square = found;
        index = at;
      }
      return true;  // go on searching
    }
  };

  /// The nearest point with a squared distance below `square`; `found` if there is none.
  std::pair<std::size_t, double> nearest(const Eigen::Vector3d& x, std::size_t found, double square) const {
    Nearest result{found, square};
    index_.findNeighbors(result, x.data(), {});
    return {result.index, std::sqrt(result.square)};
  }

  Adaptor adaptor_;
  Index index_;
};

}  // namespace isobench
