// Closes the holes that a front leaves by cutting off their corners, smallest angle first. The method's worst triangles
// come from here (Schreiner, Scheidegger, Silva 2006; Meyer, Kirby, Whitaker 2007, section 4).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/methods/advancing-front/front.h"

namespace isobench::advancing_front {

/// A loop that the front could not close.
struct Hole {
  Eigen::Vector3d centre;  ///< mean of its corners, mm
  std::size_t edges = 0;
  std::size_t triangles = 0;  ///< number made to close it
  bool closed = true;
};

/// Closes every remaining loop by cutting off corners. Where each possible cut would give an edge a third triangle, the
/// rest of the loop gets a fan round a new vertex: its centre, projected to the surface if that succeeds. A loop that
/// touches itself may allow neither; it is taken off the front and stays open.
std::vector<Hole> close_holes(const Isosurface& surface, Front& front);

}  // namespace isobench::advancing_front
