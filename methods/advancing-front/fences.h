// Whether a triangle may be added: its normal, the gaps at its corners, and the fences of the front round it. A fence
// is the ribbon that an edge of the front sweeps along its normal, so that edges that miss each other in space but
// cross on the surface are seen to cross.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "isobench/methods/advancing-front/front.h"

namespace isobench::advancing_front {

/// A triangle that is thought of: its corners, counter-clockwise from outside, the base edge's first node, and the node
/// of the third corner, −1 where that is new.
struct Tentative {
  std::array<const Vertex*, 3> corners;
  int base = -1;
  int apex = -1;
};

/// The smallest angle, radians.
double smallest_angle(const Tentative& t);
/// Circumradius over inradius: 2 where equilateral.
double circumradius_over_inradius(const Tentative& t);
/// The smallest cosine between the triangle's normal and those of its corners.
double normal_agreement(const Tentative& t);
/// The smallest angle (radians) that its new edges leave of the gaps that they divide; π where none is divided.
/// std::nullopt where an edge does not leave its corner into the gap.
std::optional<double> gaps_left(const Front& front, const Tentative& t);

/// The angle (radians) of a node's gap, in (0, 2π), seen along its normal.
double gap_angle(const Front& front, int node);

/// What the front round a triangle does to it.
enum class Fence { clear, near, crossed };

/// Looks at the fences of the edges in `edges`: `crossed` where one crosses an edge of the triangle or ends in it;
/// `near` where a fence comes nearer than `margin` (mm) to the new vertex or ends that near to a new edge. Edges whose
/// normals are far from the triangle's belong to another sheet and do not count.
Fence fences(const Front& front, const Tentative& t, const std::vector<int>& edges, double margin);

}  // namespace isobench::advancing_front
