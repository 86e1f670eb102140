// The finish: valences and shapes of a mesh made good, its vertices kept on F = c and its edges below h0.
#pragma once

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/methods/sizing/sizing_field.h"

namespace isobench::particles {

/// Rounds of collapses, divisions and flips that bring valences to 5-7, each followed by sweeps of smoothing (Σ 1/Q³);
/// then the places where a triangle, a valence or an edge is still not as wanted are searched one by one. Vertices at
/// borders and pinches stay where they are. What no search mended stays: it is counted as "finish/places left".
///
/// An edge above h0 is such a place, and no change makes one; where the sizing is uniform, lengths are left to the
/// shapes. `mesh` is a sampling of F = c that is as dense as the sizing asks.
///
/// Triangles within 60° of the normals of F at their corners do not fold, but sheets nearer than their edges are long
/// could meet. So the result is looked through for self-intersections at the end; where there are some, that
/// neighbourhood is rolled back, which is to say that the finish is done again without touching it (twice as wide a one
/// each time, in the last resort everywhere). Pairs met with are counted as "finish/intersections rolled back". What
/// `mesh` itself has of them stays.
///
/// Stages "connectivity", "shape", "tail" and "intersections" of the monitor's current stage. The same mesh for any
/// number of threads. Cost: 10 to 25 µs of one core a vertex, on all threads.
TriangleMesh finish(const Isosurface& surface, const SizingField& sizing, const TriangleMesh& mesh, int rounds,
                    Monitor& monitor);

}  // namespace isobench::particles
