// A branching vessel as a union of tapered segments: the phantom `vessel-tree`.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace isobench {

/// The union of the balls whose centre runs from `from` to `to` while their radius runs from radius_from to radius_to.
struct VesselSegment {
  Eigen::Vector3d from = Eigen::Vector3d::Zero();  ///< mm
  Eigen::Vector3d to = Eigen::Vector3d::Zero();    ///< mm
  double radius_from = 0.0;                        ///< mm, equal to the parent's radius_to
  double radius_to = 0.0;                          ///< mm, at most radius_from
  int parent = -1;                                 ///< index of the segment that it grows from; -1 for the trunk
};

/// The trunk and three generations of bifurcations, parents before children; the bounding box of all balls is centred
/// at 0. Source: C. D. Murray, The physiological principle of minimum work, PNAS 12 (1926): r0³ = r1³ + r2³ at every
/// bifurcation; and J. Gen. Physiol. 9 (1926) for the angles between the branches and the parent's direction:
/// cos θ1 = (r0⁴ + r1⁴ − r2⁴)/(2 r0² r1²). Each plane of branching is perpendicular to the one before.
const std::vector<VesselSegment>& vessel_tree();

/// The largest r(t) − |x − c(t)| over the balls of a segment, mm. Outside the segment it is minus the distance to it.
double depth_in(const VesselSegment& segment, const Eigen::Vector3d& x);

}  // namespace isobench
