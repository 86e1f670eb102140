#include "isobench/methods/particles/cure/dual_edge_crossings.h"

#include <algorithm>
#include <cmath>

namespace isobench::particles {

namespace {

// Samples along the part of a dual edge that is within the volume, at most a quarter voxel apart.
struct EdgeSamples {
  EdgeSamples(const LabelledDelaunay::Facet& facet, const Isosurface& surface) : from(facet.inside), to(facet.outside) {
    // The inner end is within the volume. The outer end may be far beyond it, where there is no surface.
    double share = 1.0;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double length = to[axis] - from[axis];
      if (length > 0.0) share = std::min(share, (surface.extent()[axis] - from[axis]) / length);
      if (length < 0.0) share = std::min(share, -from[axis] / length);
    }
    to = from + std::max(0.0, share) * (to - from);
    steps = static_cast<int>(std::ceil((to - from).norm() / (0.25 * surface.voxel())));
  }
  Eigen::Vector3d at(int step) const { return from + (static_cast<double>(step) / steps) * (to - from); }

  Eigen::Vector3d from;
  Eigen::Vector3d to;
  int steps = 0;
};

// Calls visit(from, to) for each pair of consecutive samples between which the sign of f changes.
template <class Visit>
void visit_crossings(const LabelledDelaunay::Facet& facet, const Isosurface& surface, Visit&& visit) {
  const EdgeSamples samples(facet, surface);
  bool inside = true;
  for (int step = 1; step <= samples.steps; ++step) {
    const bool now = surface.value(samples.at(step)) > 0.0;
    if (now != inside) visit(samples.at(step - 1), samples.at(step));
    inside = now;
  }
}

}  // namespace

int count_crossings(const LabelledDelaunay::Facet& facet, const Isosurface& surface) {
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
