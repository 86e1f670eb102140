// Hidden cells: the surface passes through them, but all eight corners are on one side of it. No lattice mesh shows the
// specks and cavities within such cells, which are about a voxel or less in size.
#pragma once

#include <array>
#include <vector>

#include "isobench/datasets/isosurface.h"

namespace isobench {

/// The lowest corners of all cells in which f may change sign although the corners have one sign, with x fastest. No
/// hidden cell is missed: within a cell, f is a tricubic polynomial, and it has one sign if its 64 Bernstein
/// coefficients have one sign. The result does not depend on the number of threads. Cost: one pass over the lattice,
/// about 10 ns of one core per node and 0.3 µs per cell next to the surface; 8 bytes per thread and node of a layer.
std::vector<std::array<int, 3>> hidden_cells(const Isosurface& surface);

}  // namespace isobench
