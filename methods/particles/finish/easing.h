// Easing: places that are denser than the sizing asks become as coarse again as the mesh allows.
#pragma once

#include <cstddef>

#include "isobench/methods/particles/mesh_edits/local_search.h"
#include "isobench/methods/particles/sampling/sized_surface.h"

namespace isobench::particles {

/// Bounds on h (size_bounds.h) make places dense, because particles need it there for the right topology. A mesh that
/// has the topology keeps it under collapses, so most of these places can do with fewer vertices. That allows longer
/// explicit time steps: the smallest triangles, against the size asked for, decide on them.
///
/// Raises the bounds of the place whose vertices are the smallest, and removes vertices until there are no more than
/// the raised bounds ask for (thinning.h). The mesh must come no farther from the goal, and the step factor of the
/// place must fall without harm to the conditioning (local_spectrum.h); otherwise the bounds are raised by less. This
/// is repeated for the next smallest place, until no place is much denser than asked for, or the worst place cannot
/// become coarser: then nothing would be gained at the others.
///
/// Places that are nearly as dense are tried beside the worst one, in parallel. The result does not depend on the
/// number of threads. Takes the moves off the budget. Returns how many bounds were raised.
std::size_t ease_bounds(const FinishContext& context, const SizedSurface& sized, EditableMesh& mesh,
                        const ShapeGoal& goal, SearchBudget& budget);

}  // namespace isobench::particles
