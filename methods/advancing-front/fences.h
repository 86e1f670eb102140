// The checks of a triangle before it is added: its normal, the gaps at its corners, and the fences near it. A fence is
// the ribbon that an edge of the front sweeps along its normal. With fences, two edges that cross on the surface are
// found to cross even if they miss each other in space.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "isobench/methods/advancing-front/front.h"

namespace isobench::advancing_front {

/// A triangle that may be added: its corners (counter-clockwise from outside), the first node of its base edge, and the
/// node of its third corner, −1 if that vertex is new.
struct Tentative {
  std::array<const Vertex*, 3> corners;
  int base = -1;
  int apex = -1;
};

/// The smallest angle, radians.
double smallest_angle(const Tentative& t);
/// Circumradius over inradius; 2 for an equilateral triangle.
double circumradius_over_inradius(const Tentative& t);
/// The smallest cosine between the triangle's normal and the normals at its corners.
double normal_agreement(const Tentative& t);
/// The smallest angle (radians) that remains of a gap after the triangle's new edges have divided it; π if they divide
/// none. std::nullopt if a new edge does not leave its corner into the gap, or if an angle is below 0.001.
std::optional<double> gaps_left(const Front& front, const Tentative& t);

/// The angle (radians) of a node's gap about its normal, in [0, 2π).
double gap_angle(const Front& front, int node);

/// The position of a triangle relative to the fences around it.
enum class Fence { clear, near, crossed };

/// Checks a triangle against the fences of `edges`. `crossed`: a fence crosses an edge of the triangle or ends in it.
/// `near`: a fence is nearer than `margin` (mm) to the new vertex, or ends nearer than that to a new edge. Edges whose
/// normal is nearly opposite to the triangle's are on another sheet and are ignored.
Fence fences(const Front& front, const Tentative& t, const std::vector<int>& edges, double margin);

}  // namespace isobench::advancing_front
