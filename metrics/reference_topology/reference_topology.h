// The surface's own topology, counted without any mesh. The signs of F − c are taken on a lattice that is refined k
// times, and its cells are cut into Kuhn tetrahedra: χ = edges − triangles + tetrahedra whose corners differ in sign.
// The outermost two layers of nodes count as outside.
//
// A lattice miscounts in two ways. It pierces sheets that are thinner than its edges; a few times the data's resolution
// cures that. And it misjudges a saddle or an extremum of F that is closer to the surface than the nodes are; no k
// cures that for good. But only critical points of F can be misjudged so, and they can be found. Around each of them
// the count is repeated on a lattice that is finer than the point's distance to the surface. Because χ(A ∪ B) = χ(A) +
// χ(B) − χ(A ∩ B), the fine count of a box can replace the coarse one; regions are joined over the borders of the
// boxes. On four real volumes the result is the same for k = 3 and 4, although the plain count of one of them still
// changes from k = 8 to 12.
#pragma once

#include <cstddef>

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"

namespace isobench {

struct ReferenceTopology {
  int k = 0;
  long euler = 0;
  std::size_t components = 0;
};

/// Refines slice by slice and stores signs as bits: k³/8 bytes a node of the data. The counts around critical points
/// take as many nodes again; for noise, a few times as many.
ReferenceTopology reference_topology(const Isosurface& surface, int k, Monitor& monitor);

/// The plain count, without the repeated counts around critical points.
ReferenceTopology lattice_topology(const Isosurface& surface, int k, Monitor& monitor);

}  // namespace isobench
