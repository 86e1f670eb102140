// Where a segment crosses F = c: the one question that Delaunay refinement asks of a surface.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "isobench/datasets/isosurface.h"

namespace isobench::delaunay_refinement {

/// In the volume and f > 0. What is outside the volume is outside the object, however far: circumcentres may be.
bool is_inside(const Isosurface& surface, const Eigen::Vector3d& x);

/// A point on F = c between an end that is inside and one that is not, to 1e-6 voxel along the segment; where the
/// object leaves the volume between them, the place where it does. std::nullopt where both are on one side.
/// Halved until it is no longer than a voxel, so that of several crossings one that bisection finds is taken; then a
/// bracketed secant (Illinois; Dowell, Jarratt 1971). Cost: about ten values of f.
std::optional<Eigen::Vector3d> crossing(const Isosurface& surface, const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace isobench::delaunay_refinement
