// The position of the new vertex when an edge of the front grows a triangle.
#pragma once

#include <functional>
#include <optional>

#include "isobench/datasets/isosurface.h"
#include "isobench/methods/advancing-front/front.h"

namespace isobench::advancing_front {

/// The desired edge length at a point, mm.
using Step = std::function<double(const Eigen::Vector3d&)>;

/// The lengths of the two sides that a triangle on the edge a→b has besides that edge, mm.
struct Sides {
  double from_a = 0.0;
  double from_b = 0.0;
};

/// The wanted sides if they form a triangle with angles of at least about 30° at the edge, otherwise similar ones that
/// do.
Sides feasible_sides(double edge, const Sides& wanted);

/// The point with these distances from a and b, in the plane through a→b with this normal, to the left of a→b seen from
/// the tip of the normal.
Eigen::Vector3d planar_apex(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& normal,
                            const Sides& sides);

/// Rotates that point about the edge until f = 0, which keeps both distances; the sign of f gives the direction. The
/// root is bracketed in steps of π/60 up to a right angle and then found by the method TOMS 748. std::nullopt if there
/// is no root or if it is outside the lattice.
std::optional<Eigen::Vector3d> rotate_to_surface(const Isosurface& surface, const Eigen::Vector3d& a,
                                                 const Eigen::Vector3d& b, const Eigen::Vector3d& normal,
                                                 const Sides& sides);

/// The vertex at x, with the normal from ∇f and the step from the sizing. Precondition: x is on the surface.
Vertex make_vertex(const Isosurface& surface, const Step& step, const Eigen::Vector3d& x);

/// The angles (radians) between an edge and its neighbours on the front, on the side that is not meshed.
struct GapAngles {
  double at_a = 0.0;
  double at_b = 0.0;
};

/// The vertex that the edge a→b grows. The new sides have the mean of the steps at their two ends, times `shrink` ≤ 1.
/// Where a gap has room for only two triangles, the new edge halves it.
std::optional<Vertex> grown_apex(const Isosurface& surface, const Step& step, const Vertex& a, const Vertex& b,
                                 double shrink, const GapAngles& gaps);

}  // namespace isobench::advancing_front
