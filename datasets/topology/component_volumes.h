// How much each component of F = c encloses: what tells a speck from a part of the object.
#pragma once

#include <cstddef>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/datasets/topology/certified_topology.h"

namespace isobench {

/// The volume that each component encloses, mm³: positive for the border of an island, negative for that of a cavity.
/// To about 1 %. Precondition: the topology is proven and the surface does not leave the lattice. Threads: all; the
/// result does not depend on their number. Cost: 1 µs of one core for each box of the proof, and up to 20 µs for those
/// of small components.
std::vector<double> component_volumes(const Isosurface& surface, const CertifiedTopology& topology);

/// Marks the components that enclose less than `least` mm³, islands and cavities alike, as left out, and returns their
/// number. `volumes` are component_volumes().
std::size_t leave_out_below(double least, const std::vector<double>& volumes, CertifiedTopology& topology);

}  // namespace isobench
