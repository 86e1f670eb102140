// A kd-tree over points that answers "which is nearest", over nanoflann.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <nanoflann.hpp>
#include <utility>
#include <vector>

namespace isobench {

class PointTree {
 public:
  /// Keeps a reference: the points must outlive the tree and stay as they are.
  explicit PointTree(const std::vector<Eigen::Vector3d>& points)
      : adaptor_{points}, index_(3, adaptor_, nanoflann::KDTreeSingleIndexAdaptorParams(12)) {
    index_.buildIndex();
  }
  PointTree(const PointTree&) = delete;
  PointTree& operator=(const PointTree&) = delete;

  /// Index of and distance to the point nearest to x.
  std::pair<std::size_t, double> nearest(const Eigen::Vector3d& x) const {
    std::size_t found = 0;
    double square = 0.0;
    nanoflann::KNNResultSet<double, std::size_t, std::size_t> result(1);
    result.init(&found, &square);
    index_.findNeighbors(result, x.data(), nanoflann::SearchParams());
    return {found, std::sqrt(square)};
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

  Adaptor adaptor_;
  Index index_;
};

}  // namespace isobench
