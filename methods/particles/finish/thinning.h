// Thinning: the removal of vertices from one place of a mesh.
#pragma once

#include "isobench/methods/particles/mesh_edits/editable_mesh.h"
#include "isobench/methods/particles/mesh_edits/local_search.h"
#include "isobench/methods/particles/mesh_edits/valence_edits.h"

namespace isobench::particles {

/// Removes vertices until there are no more than `context.areas` asks for, which is larger in places than `before`;
/// smooths what is left, and searches at bad spots. Takes the moves off the budget. Returns false, with a mesh that is
/// not to be used, if no vertex could be removed or if the mesh is farther than before from a goal: `goal`, or that of
/// the finish as a whole.
bool thin_out(const FinishContext& context, const AskedAreas& before, const ShapeGoal& goal, EditableMesh& mesh,
              SearchBudget& budget);

}  // namespace isobench::particles
