#include "isobench/methods/delaunay-refinement/crossing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isobench::delaunay_refinement {

namespace {

bool in_volume(const Isosurface& surface, const Eigen::Vector3d& x) {
  return (x.array() >= 0.0).all() && (x.array() <= surface.extent().array()).all();
}

/// The value of f in the volume, −∞ outside it.
double value(const Isosurface& surface, const Eigen::Vector3d& x) {
  return in_volume(surface, x) ? surface.value(x) : -std::numeric_limits<double>::infinity();
}

/// The point where the segment from x to y leaves the volume. Precondition: x is in the volume.
Eigen::Vector3d exit(const Isosurface& surface, const Eigen::Vector3d& x, const Eigen::Vector3d& y) {
  const Eigen::Vector3d way = y - x;
  double share = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double wall = way[axis] > 0.0 ? surface.extent()[axis] : 0.0;
    if (way[axis] != 0.0) share = std::min(share, (wall - x[axis]) / way[axis]);
  }
  return (x + share * way).cwiseMax(0.0).cwiseMin(surface.extent());
}

struct End {
  Eigen::Vector3d x;
  double f;
};

/// The zero of f in a bracket that is no longer than a voxel.
Eigen::Vector3d polished(const Isosurface& surface, End in, End out) {
  constexpr double tolerance = 1e-6;
  constexpr int most = 40;
  const double length = (out.x - in.x).norm();
  double at_in = 0.0;  // position along the bracket, as is at_out
  double at_out = 1.0;
  int same = 0;  // how often the inner end (> 0) or the outer end (< 0) has moved in a row
  for (int n = 0; n < most; ++n) {
    const double slope = (in.f - out.f) / (at_out - at_in);
    const double at = at_in + in.f / slope;
    Eigen::Vector3d x = (1.0 - at) * in.x + at * out.x;
    const double f = surface.value(x);
    if (std::abs(f) * length < tolerance * surface.voxel() * slope) return x;
    // The Illinois rule: halve the value at an end that has not moved for two steps, or it might never move.
    if (f > 0.0) {
      at_in = at;
      in.f = f;
      same = std::max(same, 0) + 1;
      if (same > 1) out.f *= 0.5;
    } else {
      at_out = at;
      out.f = f;
      same = std::min(same, 0) - 1;
      if (same < -1) in.f *= 0.5;
    }
  }
  const double at = 0.5 * (at_in + at_out);
  return (1.0 - at) * in.x + at * out.x;
}

}  // namespace

bool is_inside(const Isosurface& surface, const Eigen::Vector3d& x) { return value(surface, x) > 0.0; }

std::optional<Eigen::Vector3d> crossing(const Isosurface& surface, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  End in{a, value(surface, a)};
  End out{b, value(surface, b)};
  if ((in.f > 0.0) == (out.f > 0.0) || !a.allFinite() || !b.allFinite()) return std::nullopt;
  if (out.f > 0.0) std::swap(in, out);
  if (std::isinf(out.f)) {
    out.x = exit(surface, in.x, out.x);
    out.f = surface.value(out.x);
    if (out.f > 0.0) return out.x;
  }
  while ((out.x - in.x).norm() > surface.voxel()) {
    const Eigen::Vector3d middle = 0.5 * (in.x + out.x);
    const double f = surface.value(middle);
    (f > 0.0 ? in : out) = {middle, f};
  }
  return polished(surface, in, out);
}

}  // namespace isobench::delaunay_refinement
