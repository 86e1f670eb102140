#include "isobench/datasets/phantoms/phantom_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "isobench/datasets/phantoms/vessel_tree.h"

namespace isobench {

namespace {

using Eigen::Vector3d;
using std::numbers::pi;

}  // namespace

// The inner medial axis is the two centres, the outer one the plane between the spheres.
Phantom sphere_pair(double radius, double gap) {
  const auto from_centre = [radius, gap](const Vector3d& x) {
    return Vector3d(std::abs(x[0]) - (radius + 0.5 * gap), x[1], x[2]).norm();
  };
  Phantom p;
  p.function = [radius, from_centre](const Vector3d& x) { return radius - from_centre(x); };
  p.half_extent = {2.0 * radius + 0.5 * gap, radius, radius};
  p.euler = 4;
  p.components = 2;
  p.feature_size = [from_centre](const Vector3d& x) { return std::min(from_centre(x), std::abs(x[0])); };
  p.smallest_feature = std::min(radius, 0.5 * gap);
  p.area = 8.0 * pi * radius * radius;
  p.volume = 8.0 / 3.0 * pi * radius * radius * radius;
  return p;
}

Phantom near_spheres(double gap) {
  Phantom p = sphere_pair(10.0, gap);
  p.name = "near-spheres";
  p.title = fmt::format("Two spheres of radius 10 mm, {} mm apart", gap);
  p.parameters = {{"gap", gap, 0.01, 100.0, "between the spheres"}};
  return p;
}

// A plate is everything within half the thickness of a disc. The inner medial axis is the two discs, everywhere half
// the thickness from the surface; the outer one is the plane between the plates, half the gap from the sides that face
// each other.
Phantom thin_sheets(double thickness, double gap) {
  constexpr double disc = 18.0;
  const double half = 0.5 * thickness;
  const auto from_disc = [half, gap](const Vector3d& x) {
    return std::hypot(std::max(0.0, std::hypot(x[0], x[1]) - disc), std::abs(x[2]) - (0.5 * gap + half));
  };
  Phantom p;
  p.name = "thin-sheets";
  p.title =
      fmt::format("Two round plates, {:g} mm across and {} mm thick, {} mm apart", 2.0 * (disc + half), thickness, gap);
  p.parameters = {{"thickness", thickness, 0.01, 100.0, "of each plate"}, {"gap", gap, 0.01, 100.0, "between them"}};
  p.function = [half, from_disc](const Vector3d& x) { return half - from_disc(x); };
  p.half_extent = {disc + half, disc + half, thickness + 0.5 * gap};
  p.euler = 4;
  p.components = 2;
  p.feature_size = [from_disc](const Vector3d& x) { return std::min(from_disc(x), std::abs(x[2])); };
  p.smallest_feature = 0.5 * std::min(thickness, gap);
  p.area = 2.0 * (2.0 * pi * disc * disc + 2.0 * pi * pi * disc * half + 4.0 * pi * half * half);
  p.volume = 2.0 * (2.0 * pi * disc * disc * half + pi * pi * disc * half * half + 4.0 / 3.0 * pi * half * half * half);
  return p;
}

// A union of convex sets. Outside, the distance to the nearest set is the distance to the union. Inside, the largest
// depth in one set is only a lower bound of the depth in the union, and λ goes to 0 at the creases of the bifurcations;
// so the phantom states neither.
Phantom vessel_tree_phantom() {
  Phantom p;
  p.name = "vessel-tree";
  p.title = "Vessel of radius 4 mm that branches three times, down to 1.6 mm";
  p.function = [](const Vector3d& x) {
    double deepest = -std::numeric_limits<double>::infinity();
    for (const VesselSegment& segment : vessel_tree()) deepest = std::max(deepest, depth_in(segment, x));
    return deepest;
  };
  p.exact_distance = false;
  p.half_extent = Vector3d::Zero();
  double thinnest = std::numeric_limits<double>::infinity();
  for (const VesselSegment& s : vessel_tree()) {
    p.half_extent = p.half_extent.cwiseMax(s.from.cwiseAbs() + Vector3d::Constant(s.radius_from));
    p.half_extent = p.half_extent.cwiseMax(s.to.cwiseAbs() + Vector3d::Constant(s.radius_to));
    thinnest = std::min(thinnest, s.radius_to);
  }
  p.smallest_radius = thinnest;
  return p;
}

}  // namespace isobench
