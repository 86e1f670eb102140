// The tail of the finish: finds the bad spots of a mesh and searches for something better at each (local_search.h).
#pragma once

#include <cstddef>

#include "isobench/methods/particles/mesh_edits/local_search.h"

namespace isobench::particles {

/// Searches at all bad spots whose submeshes do not overlap, in parallel. Returns how many were improved. The result
/// does not depend on the number of threads. If the budget is too small for all of them, the worst spots come first.
/// Takes the moves off the budget.
std::size_t improve_bad_spots(const FinishContext& context, EditableMesh& mesh, const ShapeGoal& goal,
                              const SearchEffort& search, SearchBudget& budget);

/// About the moves that these searches would take if they found nothing better.
double expected_moves(const FinishContext& context, const EditableMesh& mesh, const ShapeGoal& goal,
                      const SearchEffort& search);

/// The number of bad spots: vertices whose valence misses the goal, and triangles that miss it or have an edge above
/// h0. A spot without a movable vertex does not count.
std::size_t count_bad_spots(const FinishContext& context, const EditableMesh& mesh, const ShapeGoal& goal);

}  // namespace isobench::particles
