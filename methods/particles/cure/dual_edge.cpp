#include "isobench/methods/particles/cure/dual_edge.h"

#include <algorithm>
#include <cmath>

namespace isobench::particles {

namespace {

// The part of a dual edge that lies in the volume, as a start and a number of steps of at most a quarter voxel.
struct Walk {
  Walk(const LabelledDelaunay::Facet& facet, const Isosurface& surface) : from(facet.inside), to(facet.outside) {
    // Inside is in the volume; outside may be far beyond it, where nothing is crossed any more.
    double share = 1.0;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double way = to[axis] - from[axis];
      if (way > 0.0) share = std::min(share, (surface.extent()[axis] - from[axis]) / way);
      if (way < 0.0) share = std::min(share, -from[axis] / way);
    }
    to = from + std::max(0.0, share) * (to - from);
    steps = static_cast<int>(std::ceil((to - from).norm() / (0.25 * surface.voxel())));
  }
  Eigen::Vector3d at(int step) const { return from + (static_cast<double>(step) / steps) * (to - from); }

  Eigen::Vector3d from;
  Eigen::Vector3d to;
  int steps = 0;
};

// Calls visit(from, to) for each pair of neighbouring steps between which the sign changes.
template <class Visit>
void visit_crossings(const LabelledDelaunay::Facet& facet, const Isosurface& surface, Visit&& visit) {
  const Walk walk(facet, surface);
  bool inside = true;
  for (int step = 1; step <= walk.steps; ++step) {
    const bool now = surface.value(walk.at(step)) > 0.0;
    if (now != inside) visit(walk.at(step - 1), walk.at(step));
    inside = now;
  }
}

}  // namespace

int crossings(const LabelledDelaunay::Facet& facet, const Isosurface& surface) {
  int count = 0;
  visit_crossings(facet, surface, [&](const Eigen::Vector3d&, const Eigen::Vector3d&) { ++count; });
  return count;
}

std::vector<Eigen::Vector3d> crossing_points(const LabelledDelaunay::Facet& facet, const Isosurface& surface) {
  std::vector<Eigen::Vector3d> points;
  visit_crossings(facet, surface, [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const auto foot = surface.project(0.5 * (from + to));
    if (foot) points.push_back(*foot);
  });
  return points;
}

}  // namespace isobench::particles
