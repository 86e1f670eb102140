// Where a lattice may miscount the topology of F = c however fine it is: close to critical points of F.
#pragma once

#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/metrics/reference_topology/sign_lattice.h"

namespace isobench {

struct CriticalBox {
  NodeBox box;
  double distance = 0.0;  ///< voxels: the least that a critical point in it has to the surface
};

/// Boxes of the surface's lattice that have two cells or more all round every critical point of F that is less than
/// `reach` voxels from the surface (methods/sizing/critical_points/critical_points.h), and round what lies between the
/// nodes. No two share a node. The same for any number of threads.
std::vector<CriticalBox> critical_boxes(const Isosurface& surface, double reach);

}  // namespace isobench
