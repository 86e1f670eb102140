// Cells into which the surface reaches though their corners do not tell: all eight on one side. What lies wholly within
// such cells, specks and cavities of less than a voxel or so, is on no lattice of nodes.
#pragma once

#include <array>
#include <vector>

#include "isobench/datasets/isosurface.h"

namespace isobench {

/// The lowest corners of the cells in which f may change sign without a corner of another sign; x fastest. None is
/// left out: within a cell f is a tricubic polynomial, and where its 64 Bernstein coefficients have one sign, it has.
/// Multi-threaded, the same for any number of threads. One pass over the lattice, about 10 ns of one core a node and
/// 0.3 µs a cell next to the surface; memory is four slabs a thread.
std::vector<std::array<int, 3>> hidden_cells(const Isosurface& surface);

}  // namespace isobench
