// The surface's own topology, counted independently of any mesher: the signs of F − c on a k-times refined lattice, cut
// into Kuhn tetrahedra, χ = bichromatic edges − triangles + tetrahedra; the outermost two layers count as outside.
//
// A lattice miscounts in two ways: it pierces sheets that are thinner than its edges, which a few times the data's
// resolution cures, and it cannot tell on which side of c a saddle or an extremum of F is that comes closer to the
// surface than its nodes, which no k cures for good. Only a critical point of F can be of the second kind, and these
// are found; around each, the count is made anew on a lattice finer than its distance to the surface. χ adds up over
// parts of space, χ(A ∪ B) = χ(A) + χ(B) − χ(A ∩ B), and so the fine count takes the place of the coarse one; regions
// are joined over the boxes' borders. On four real volumes it is the same at k = 3 and 4; of one, the plain count was
// still moving at 12.
#pragma once

#include <cstddef>

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

/// Where nobody asks for another k: sheets of a third of a voxel hold.
inline constexpr int default_reference_k = 3;

struct ReferenceTopology {
  int k = 0;
  long euler = 0;
  std::size_t components = 0;
};

/// Time and memory: separable refinement slice by slice, signs as bits; k³ nodes/8 bytes. Around critical points as
/// many nodes again, or a few times that, where the data are noise.
ReferenceTopology reference_topology(const Isosurface& surface, int k, Monitor& monitor);

/// The plain count, without a closer look anywhere.
ReferenceTopology lattice_topology(const Isosurface& surface, int k, Monitor& monitor);

}  // namespace isobench
