// Topology of the surface between the inside and outside nodes of a lattice cut into Kuhn tetrahedra: six a cube, all
// along its main diagonal, so that each node has 7 edges, 12 triangles and 6 tetrahedra of its own.
#pragma once

#include <cstddef>

#include "datasets/monitor.h"
#include "metrics/sign_lattice.h"

namespace isobench {

/// χ = bichromatic edges − triangles + tetrahedra: each is crossed by one vertex, edge or face of the surface.
/// Precondition of both: the outermost layer is outside. With all threads.
long kuhn_euler(const SignLattice& signs, Monitor& monitor);

/// Connected components of the surface. Each separates space in two, so that inside and outside regions form a tree
/// with the components as its edges: one fewer than regions of nodes, connected over the 14 edges at each node.
std::size_t kuhn_components(const SignLattice& signs, Monitor& monitor);

}  // namespace isobench
