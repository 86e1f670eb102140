// The surface's own topology, counted independently of any mesher: the signs of F − c on a k-times refined lattice, cut
// into Kuhn tetrahedra, χ = bichromatic edges − triangles + tetrahedra; the outermost two layers count as outside.
// "The right topology" of a real volume is a question of resolution: the k is always stated beside it.
#pragma once

#include <cstddef>

#include "datasets/isosurface.h"
#include "datasets/monitor.h"

namespace isobench {

/// Where nobody asks for another k: finer than the data, yet seconds on a volume.
inline constexpr int default_reference_k = 2;

struct ReferenceTopology {
  int k = 0;
  long euler = 0;
  std::size_t components = 0;
};

/// Time and memory: separable refinement slice by slice, signs as bits; k³ nodes/8 bytes.
ReferenceTopology reference_topology(const Isosurface& surface, int k, Monitor& monitor);

}  // namespace isobench
