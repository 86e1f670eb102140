#include "isobench/methods/sizing/medial_axis/foot_points.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "isobench/methods/sizing/medial_axis/point_tree.h"

namespace isobench {

namespace {

constexpr double least_cosine = 0.9;     // cosine of the largest angle between pq and p*q* on one side of the axis
constexpr double shell = 0.1;            // voxels; nearer to the surface, the direction to the foot is inaccurate
constexpr double foot_tolerance = 1e-3;  // voxels; largest tangential part of q − p
constexpr double refined_within = 2.0;   // a cell is halved if it is within this many cell sizes of the surface

class AxisSearch {
 public:
  AxisSearch(const Isosurface& surface, const SurfaceSamples& samples)
      : surface_(surface), samples_(samples), tree_(samples.points), voxel_(surface.voxel()) {}

  struct Found {
    Eigen::Vector3d point;
    double radius;
  };

  /// Adds the points found from the lower corner q of a cell, and from the lower corners of the cells into which it is
  /// divided. `cell` is the size of the cell and `cuts` the number of halvings left. `guess` is a sample near q, where
  /// the search starts.
  void search(const Eigen::Vector3d& q, const Eigen::Vector3d& cell, int cuts, std::size_t& guess,
              std::vector<Found>& found) const {
    const double distance = to_samples(q, guess);
    if (const auto point = at(q, cell, guess)) found.push_back(*point);
    if (cuts == 0 || distance > refined_within * cell.maxCoeff()) return;
    std::size_t near = guess;
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d offset(corner & 1, corner >> 1 & 1, corner >> 2);
      search(q + 0.5 * cell.cwiseProduct(offset), 0.5 * cell, cuts - 1, near, found);
    }
  }

 private:
  /// Returns the distance from q to the nearest sample, which becomes `guess`.
  double to_samples(const Eigen::Vector3d& q, std::size_t& guess) const {
    const auto [nearest, distance] = tree_.nearest(q, guess);
    guess = nearest;
    return distance;
  }

  /// The axis point between q and the point where the ray from the foot of q leaves the cell. `nearest` is the sample
  /// nearest to q.
  std::optional<Found> at(const Eigen::Vector3d& q, const Eigen::Vector3d& cell, std::size_t nearest) const {
    const Eigen::Vector3d& near_q = samples_.points[nearest];
    std::optional<Eigen::Vector3d> q_far = leave_cell(q, q - near_q, cell);
    if (!q_far) return std::nullopt;
    const Eigen::Vector3d* near_far = &samples_.points[tree_.nearest(*q_far, nearest).first];
    if (surely_one_sheet(q - near_q, *q_far - *near_far)) return std::nullopt;

    const Eigen::Vector3d p = foot(q, near_q);
    const double distance = (q - p).norm();
    if (distance < shell * voxel_) return std::nullopt;
    const Eigen::Vector3d u = (q - p) / distance;
    q_far = leave_cell(q, u, cell);
    if (!q_far) return std::nullopt;
    near_far = &samples_.points[tree_.nearest(*q_far, nearest).first];
    const Eigen::Vector3d p_far = foot(*q_far, *near_far);
    const Eigen::Vector3d apart = *q_far - p_far;
    // The foot p may be nearer to q* than p_far is, because the search started from another sample. Then there is no
    // crossing.
    if (apart.norm() >= (*q_far - p).norm() || apart.norm() < shell * voxel_) return std::nullopt;
    const Eigen::Vector3d n = apart.normalized();
    if (u.dot(n) >= least_cosine) return std::nullopt;
    const double radius = (p - p_far).dot(n) / (1.0 - u.dot(n));
    if (!(radius >= distance && radius <= (*q_far - p).norm())) return std::nullopt;
    return Found{p + radius * u, radius};
  }

  /// The point where the ray from a node leaves the first cell on its way; nothing if that is outside the volume.
  std::optional<Eigen::Vector3d> leave_cell(const Eigen::Vector3d& node, const Eigen::Vector3d& direction,
                                            const Eigen::Vector3d& cell) const {
    double length = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      if (direction[axis] != 0.0) length = std::min(length, cell[axis] / std::abs(direction[axis]));
    }
    if (!std::isfinite(length)) return std::nullopt;
    Eigen::Vector3d far = node + length * direction;
    const double rounding = 1e-9 * voxel_;
    if ((far.array() < -rounding).any() || (far.array() > surface_.extent().array() + rounding).any()) {
      return std::nullopt;
    }
    return far;
  }

  /// A foot is within about a voxel of its nearest sample. Therefore, for most nodes far from the surface, the samples
  /// alone show that both feet are on one sheet.
  bool surely_one_sheet(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    const double shorter = std::min(a.norm(), b.norm());
    const double doubt = 2.0 * surface_.lattice().spacing.maxCoeff();
    if (shorter <= doubt) return false;
    const double angle = std::acos(std::clamp(a.dot(b) / (a.norm() * b.norm()), -1.0, 1.0));
    return angle + std::asin(doubt / shorter) < std::acos(least_cosine);
  }

  /// The surface point nearest to q, starting from a sample near it. Takes tangential steps, each projected to the
  /// surface, and halves the step if it leads away from q.
  Eigen::Vector3d foot(const Eigen::Vector3d& q, const Eigen::Vector3d& start) const {
    constexpr int max_steps = 10;
    Eigen::Vector3d p = start;
    double square = (q - p).squaredNorm();
    double damping = 1.0;
    for (int step = 0; step < max_steps; ++step) {
      const Eigen::Vector3d n = outward_normal(surface_.value_gradient(p).gradient);
      Eigen::Vector3d along = (q - p) - n * n.dot(q - p);
      const double length = along.norm();
      if (!(length > foot_tolerance * voxel_)) break;
      along *= damping * std::min(1.0, voxel_ / length);
      const auto next = surface_.project(p + along);
      if (next && (q - *next).squaredNorm() < square) {
        p = *next;
        square = (q - p).squaredNorm();
      } else {
        damping *= 0.5;
      }
    }
    return p;
  }

  const Isosurface& surface_;
  const SurfaceSamples& samples_;
  PointTree tree_;
  double voxel_;
};

}  // namespace

MedialBalls foot_point_axis(const Isosurface& surface, const SurfaceSamples& samples, Monitor& monitor, int halvings) {
  MedialBalls axis;
  if (samples.points.empty()) return axis;
  const AxisSearch nodes(surface, samples);
  const std::array<int, 3>& size = surface.lattice().size;
  const Eigen::Vector3d& spacing = surface.lattice().spacing;
  std::vector<std::vector<AxisSearch::Found>> rows(static_cast<std::size_t>(size[1]));
  for (int k = 0; k < size[2]; ++k) {
    monitor.progress(static_cast<double>(k) / size[2]);
    tbb::parallel_for(0, size[1], [&](int j) {
      auto& row = rows[static_cast<std::size_t>(j)];
      row.clear();
      std::size_t guess = 0;
      for (int i = 0; i < size[0]; ++i) {
        nodes.search(spacing.cwiseProduct(Eigen::Vector3d(i, j, k)), spacing, halvings, guess, row);
      }
    });
    for (const auto& row : rows) {
      for (const AxisSearch::Found& found : row) {
        axis.centres.push_back(found.point);
        axis.radii.push_back(found.radius);
      }
    }
  }
  return axis;
}

}  // namespace isobench
