// Places where a lattice of any resolution may miscount the topology of F = c: close to critical points of F.
#pragma once

#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/metrics/reference_topology/sign_lattice.h"

namespace isobench {

struct CriticalBox {
  NodeBox box;
  double distance = 0.0;  ///< voxels; of its critical point that is nearest to the surface
};

/// Boxes of the surface's lattice around every critical point of F that is closer than `reach` voxels to the surface,
/// and around every speck or cavity that no node shows (methods/sizing/critical_points/critical_points.h). A box
/// reaches at least two cells beyond the point's cell, but not beyond the lattice. No two boxes share a node. The
/// result does not depend on the number of threads.
std::vector<CriticalBox> critical_boxes(const Isosurface& surface, double reach);

}  // namespace isobench
