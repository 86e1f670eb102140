// The finish: improves the valences and the triangle shapes of a mesh, with vertices on F = c and edges not above h0.
#pragma once

#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/methods/particles/sampling/sized_surface.h"

namespace isobench::particles {

struct FinishOptions {
  int rounds = 3;
  double area_weight = 1.0;  ///< multiplies the weight of areas in the energy; 0: shapes alone
  double easing = 1.0;       ///< multiplies the budget of easing; 0: dense places stay as they are
};

/// Each of the rounds changes connectivity by collapses, vertex splits and flips, which bring valences to 5–7, and
/// then smooths the vertices: it minimises an energy of shapes and areas (shape_energy.h), so that triangles become
/// equilateral and as large as the sizing asks (asked_areas.h). After the rounds, local searches (bad_spots.h) improve
/// the remaining bad spots: triangles, valences and edges that miss their goal. In the end, places that bounds on h
/// made dense become as coarse again as they can be (easing.h). Vertices at borders and pinches stay where they
/// are. Searches and easing have budgets in proportion to the mesh; what the searches spend is counted as
/// "finish/searched moves", the spots that are left as "finish/places left", and what easing did as "finish/bounds
/// raised".
///
/// With an adaptive sizing, edges above h0 are bad spots, and flips and collapses do not add any. With a uniform
/// sizing, edge lengths are not checked. `mesh` samples F = c as densely as the sizing asks.
///
/// Triangles within 60° of the normals of F at their corners do not fold over, but sheets that are closer than the
/// edges are long could intersect. So the result is checked for self-intersections. If there are new ones, the finish
/// runs again and leaves the vertices near them untouched; this neighbourhood doubles with each attempt, and after five
/// attempts the given mesh is returned. Intersecting pairs of triangles are counted as "finish/intersections rolled
/// back". Self-intersections of the given mesh may remain.
///
/// Stages "connectivity", "shape", "tail", "easing" and "intersections" of the monitor's current stage. The result does
/// not depend on the number of threads. Cost: 10 to 25 µs of CPU time a vertex, on all threads; at most about 1 ms a
/// vertex, and a few seconds, for a mesh with very many bad spots.
TriangleMesh finish(const SizedSurface& sized, const TriangleMesh& mesh, const FinishOptions& options,
                    Monitor& monitor);

}  // namespace isobench::particles
