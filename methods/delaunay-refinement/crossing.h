// Where a segment crosses F = c: all that Delaunay refinement needs to know of the surface.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "isobench/datasets/isosurface.h"

namespace isobench::delaunay_refinement {

/// Whether x is in the volume and f(x) > 0. Points outside the volume are outside the object; circumcentres may be far
/// from the volume.
bool is_inside(const Isosurface& surface, const Eigen::Vector3d& x);

/// A point on F = c on the segment from a to b, accurate to 1e-6 voxel along it, if one end is inside the object and
/// the other is not. If the object reaches the border of the volume between them, the point is where the segment leaves
/// the volume. std::nullopt if both ends are on one side. Method: bisection until the bracket is no longer than a
/// voxel, then the Illinois variant of regula falsi (Dowell, Jarratt 1971). If there are several crossings, bisection
/// decides which one is found. Cost: about ten values of f.
std::optional<Eigen::Vector3d> crossing(const Isosurface& surface, const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace isobench::delaunay_refinement
