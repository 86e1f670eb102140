#include "isobench/datasets/phantoms/vessel_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace isobench {

namespace {

using Eigen::Vector3d;

constexpr int generations = 3;
constexpr double trunk_radius = 4.0;
constexpr double length_over_radius = 5.0;
constexpr double share = 0.6;  // of the flow, proportional to r³, that the larger branch takes

/// A segment's direction, and the direction across it along which its branches separate.
struct Heading {
  Vector3d along;
  Vector3d across;
};

Heading branch_off(const Heading& parent, double angle) {
  const Vector3d along = std::cos(angle) * parent.along + std::sin(angle) * parent.across;
  return {along, parent.along.cross(parent.across)};  // perpendicular to the plane of this branching
}

/// Murray's angle of a branch of radius r1 beside one of radius r2, from a parent of radius r0.
double murray_angle(double r0, double r1, double r2) {
  return std::acos((std::pow(r0, 4) + std::pow(r1, 4) - std::pow(r2, 4)) / (2.0 * r0 * r0 * r1 * r1));
}

void grow(std::vector<VesselSegment>& tree, const VesselSegment& segment, const Heading& heading, int generation) {
  const int index = static_cast<int>(tree.size());
  tree.push_back(segment);
  if (generation == generations) return;
  const double r0 = segment.radius_to;
  const double r1 = r0 * std::cbrt(share);
  const double r2 = r0 * std::cbrt(1.0 - share);
  const auto branch = [&](double radius, double angle) {
    const Heading to = branch_off(heading, angle);
    const Vector3d end = segment.to + length_over_radius * radius * to.along;
    grow(tree, {segment.to, end, r0, radius, index}, to, generation + 1);
  };
  branch(r1, murray_angle(r0, r1, r2));
  branch(r2, -murray_angle(r0, r2, r1));
}

void centre(std::vector<VesselSegment>& tree) {
  Vector3d low = Vector3d::Constant(1e9);
  Vector3d high = -low;
  for (const VesselSegment& s : tree) {
    low = low.cwiseMin(s.from - Vector3d::Constant(s.radius_from));
    low = low.cwiseMin(s.to - Vector3d::Constant(s.radius_to));
    high = high.cwiseMax(s.from + Vector3d::Constant(s.radius_from));
    high = high.cwiseMax(s.to + Vector3d::Constant(s.radius_to));
  }
  const Vector3d middle = 0.5 * (low + high);
  for (VesselSegment& s : tree) {
    s.from -= middle;
    s.to -= middle;
  }
}

}  // namespace

const std::vector<VesselSegment>& vessel_tree() {
  static const std::vector<VesselSegment> tree = [] {
    std::vector<VesselSegment> made;
    const VesselSegment trunk{Vector3d::Zero(), length_over_radius * trunk_radius * Vector3d::UnitX(), trunk_radius,
                              trunk_radius, -1};
    grow(made, trunk, {Vector3d::UnitX(), Vector3d::UnitY()}, 0);
    centre(made);
    return made;
  }();
  return tree;
}

// The depth is concave in t, so its maximum is at the stationary point, or at the nearer end if that point lies beyond
// it. For a point y along the axis and ρ across it, and s = (radius_from − radius_to)/length, the stationary point is
// y − ρ s/√(1 − s²) along the axis.
double depth_in(const VesselSegment& segment, const Vector3d& x) {
  const Vector3d axis = segment.to - segment.from;
  const double length = axis.norm();
  const double slope = (segment.radius_from - segment.radius_to) / length;
  const Vector3d d = x - segment.from;
  const double along = d.dot(axis) / length;
  const double across = std::sqrt(std::max(0.0, d.squaredNorm() - along * along));
  const double t = std::clamp((along - across * slope / std::sqrt(1.0 - slope * slope)) / length, 0.0, 1.0);
  const double radius = segment.radius_from + t * (segment.radius_to - segment.radius_from);
  return radius - (d - t * axis).norm();
}

}  // namespace isobench
