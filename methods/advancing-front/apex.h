// Where a triangle that grows from an edge of the front has its new vertex.
#pragma once

#include <functional>
#include <optional>

#include "isobench/datasets/isosurface.h"
#include "isobench/methods/advancing-front/front.h"

namespace isobench::advancing_front {

/// How long edges shall be at a point, mm.
using Step = std::function<double(const Eigen::Vector3d&)>;

/// The sides from a and from b of a triangle on an edge of this length, mm.
struct Sides {
  double from_a = 0.0;
  double from_b = 0.0;
};

/// Sides of the wanted lengths where they make a triangle with angles above about 30° at the edge; else lengths nearest
/// to them that do.
Sides feasible_sides(double edge, const Sides& wanted);

/// The point with these distances from a and b, to the left of a→b seen along −normal, in the plane with that normal.
Eigen::Vector3d planar_apex(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& normal,
                            const Sides& sides);

/// Turns that point about the edge, up or down as the sign of f says, until f = 0: both distances are kept. The root is
/// bracketed in steps of π/60 up to a right angle and then found by Brent's kind of search. std::nullopt where there is
/// none, or it is outside the lattice.
std::optional<Eigen::Vector3d> rotate_to_surface(const Isosurface& surface, const Eigen::Vector3d& a,
                                                 const Eigen::Vector3d& b, const Eigen::Vector3d& normal,
                                                 const Sides& sides);

/// A vertex on the surface: its normal from ∇f, its step from the sizing.
Vertex make_vertex(const Isosurface& surface, const Step& step, const Eigen::Vector3d& x);

/// The angles (radians) of the gaps at the ends of an edge, between it and its neighbours on the front.
struct GapAngles {
  double at_a = 0.0;
  double at_b = 0.0;
};

/// The vertex that grows from a→b. Its sides are means of the steps at their two ends, times `shrink` ≤ 1; where a gap
/// has room for two triangles only, the new edge goes half way between, so that both become alike.
std::optional<Vertex> grown_apex(const Isosurface& surface, const Step& step, const Vertex& a, const Vertex& b,
                                 double shrink, const GapAngles& gaps);

}  // namespace isobench::advancing_front
