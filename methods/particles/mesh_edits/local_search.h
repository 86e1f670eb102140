// A search for a better submesh around a bad spot: it tries changes of connectivity, each followed by smoothing.
#pragma once

#include "isobench/methods/particles/mesh_edits/shortfall.h"
#include "isobench/methods/particles/mesh_edits/submesh.h"
#include "isobench/methods/particles/mesh_edits/valence_edits.h"

namespace isobench::particles {

/// The extent of a search.
struct SearchEffort {
  int rings = 3;  ///< size of the submesh (extract_submesh)
  int depth = 1;  ///< number of changes in a row
  int beam = 1;   ///< number of states kept after each change
};

/// The work that searches may still do, counted in attempts to move a vertex. Each takes 1 to 3 µs.
struct SearchBudget {
  double moves = 0.0;
};

/// What a search did.
struct Searched {
  bool improved = false;
  double moves = 0.0;
};

/// Tries flips, collapses and splits around the core, each with smoothing. If the best result reduces the shortfall by
/// at least 1 %, the submesh becomes that result. Tries no further change after the moves of the budget.
Searched improve(const FinishContext& context, Submesh& submesh, const ShapeGoal& goal, const SearchEffort& search,
                 const SearchBudget& budget);

/// About the moves that improve() takes if it finds no way to meet the goal.
double expected_moves(const Submesh& submesh, const SearchEffort& search);

}  // namespace isobench::particles
