// What closes the holes that a front leaves: their corners are cut off, smallest angle first. This is where the
// method's worst triangles come from (Schreiner, Scheidegger, Silva 2006; Meyer, Kirby, Whitaker 2007, section 4).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/methods/advancing-front/front.h"

namespace isobench::advancing_front {

/// A loop that the front could not close by itself.
struct Hole {
  Eigen::Vector3d centre;  ///< mean of its corners, mm
  std::size_t edges = 0;
  std::size_t triangles = 0;  ///< made to close it
  bool closed = true;
};

/// Closes every loop that is left: corners are cut off, and where every cut would use an edge a third time the loop
/// gets a fan round a new vertex near its centre, on the surface if that can be reached. A loop that touches itself may
/// allow neither: it is taken off the front and stays open.
std::vector<Hole> close_holes(const Isosurface& surface, Front& front);

}  // namespace isobench::advancing_front
