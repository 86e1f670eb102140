#include "isobench/methods/mesh_files/polygon_cutter.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace isobench {

namespace {

double cross2(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

/// Fills plane_; false if there is no such plane.
bool PolygonCutter::project(std::span<const Eigen::Vector3d> points) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double extent = 0.0;
  for (std::size_t n = 0; n < points.size(); ++n) {
    const Eigen::Vector3d a = points[n] - points[0], b = points[(n + 1) % points.size()] - points[0];
    normal += a.cross(b);
    extent = std::max(extent, a.norm());
  }
  const double length = normal.norm();
  if (!std::isfinite(length) || !(length > 1e-14 * extent * extent)) return false;
  normal /= length;
  const Eigen::Vector3d u = normal.unitOrthogonal();
  const Eigen::Vector3d v = normal.cross(u);
  plane_.clear();
  for (const Eigen::Vector3d& point : points) plane_.emplace_back(u.dot(point - points[0]), v.dot(point - points[0]));
  // Files in single precision move corners of a straight side off their line by up to 1e-7 of the coordinates.
  gap_ = 1e-6 * extent;
  return true;
}

void PolygonCutter::fan(std::size_t count) {
  for (Index n = 2; n < count; ++n) triangles_.push_back({0, n - 1, n});
}

/// Twice the area of a, b, c; positive if they turn left.
double PolygonCutter::turn(Index a, Index b, Index c) const {
  return cross2(plane_[b] - plane_[a], plane_[c] - plane_[a]);
}

/// Of a triangle: its area by the squares of its sides, which is largest for equal sides and negative if it turns
/// right.
double PolygonCutter::shape(Index a, Index b, Index c) const {
  const double sides = (plane_[b] - plane_[a]).squaredNorm() + (plane_[c] - plane_[b]).squaredNorm() +
                       (plane_[a] - plane_[c]).squaredNorm();
  return sides > 0.0 ? turn(a, b, c) / sides : 0.0;
}

/// Whether p is left of the line, on it, or nearly.
bool PolygonCutter::beside(Index from, Index to, Index p) const {
  return turn(from, to, p) >= -gap_ * (plane_[to] - plane_[from]).norm();
}

void PolygonCutter::update(Index corner) {
  const Index a = previous_[corner], c = next_[corner];
  convex_[corner] = turn(a, corner, c) > gap_ * (plane_[c] - plane_[a]).norm() ? 1 : 0;
  shape_[corner] = shape(a, corner, c);
  blocker_[corner] = corner;  // is no blocker: it makes best_ear() look for one
}

void PolygonCutter::update_all() {
  for (const Index corner : left_) update(corner);
}

/// A corner that lies in the ear or on its rim. If any does, one that is not convex does, so only those are tried.
PolygonCutter::Index PolygonCutter::blocker_of(Index ear) const {
  const Index a = previous_[ear], c = next_[ear];
  for (const Index p : left_) {
    if (convex_[p] != 0 || p == a || p == ear || p == c) continue;
    if (is_near(p, a) || is_near(p, ear) || is_near(p, c)) continue;  // a slit to a hole goes there and back
    if (beside(a, ear, p) && beside(ear, c, p) && beside(c, a, p)) return p;
  }
  return none;
}

/// `none` if no corner can be clipped.
PolygonCutter::Index PolygonCutter::best_ear() {
  Index best = none;
  double best_shape = 0.0;
  for (const Index ear : left_) {
    if (convex_[ear] == 0) continue;
    double worst = shape_[ear];
    if (left_.size() == 4) worst = std::min(worst, shape(next_[ear], next_[next_[ear]], previous_[ear]));
    if (!(worst > best_shape)) continue;
    const Index known = blocker_[ear];
    if (known != none && known != ear && place_[known] != none && convex_[known] == 0) continue;
    if (known != none) blocker_[ear] = blocker_of(ear);
    if (blocker_[ear] != none) continue;
    best = ear;
    best_shape = worst;
  }
  return best;
}

void PolygonCutter::clip(Index ear) {
  const Index a = previous_[ear], c = next_[ear];
  triangles_.push_back({a, ear, c});
  next_[a] = c;
  previous_[c] = a;
  const Index moved = left_.back();
  left_[place_[ear]] = moved;
  place_[moved] = place_[ear];
  place_[ear] = none;
  left_.pop_back();
  update(a);
  update(c);
}

bool PolygonCutter::cut(std::span<const Eigen::Vector3d> points) {
  triangles_.clear();
  const auto count = static_cast<Index>(points.size());
  if (!project(points)) {
    fan(count);
    return false;
  }
  left_.resize(count);
  place_.resize(count);
  next_.resize(count);
  previous_.resize(count);
  convex_.resize(count);
  shape_.resize(count);
  blocker_.resize(count);
  for (Index n = 0; n < count; ++n) {
    left_[n] = place_[n] = n;
    next_[n] = n + 1 < count ? n + 1 : 0;
    previous_[n] = n > 0 ? n - 1 : count - 1;
  }
  update_all();
  bool simple = true;
  while (left_.size() > 3) {
    Index ear = best_ear();
    if (ear == none && gap_ > 0.0) {  // what is left is thinner than the gap
      gap_ = 0.0;
      update_all();
      continue;
    }
    if (ear == none) {
      simple = false;
      ear = *std::max_element(left_.begin(), left_.end(), [this](Index a, Index b) { return shape_[a] < shape_[b]; });
    }
    clip(ear);
  }
  const Index last = left_[0];
  triangles_.push_back({previous_[last], last, next_[last]});
  return simple && turn(previous_[last], last, next_[last]) >= 0.0;
}

}  // namespace isobench
