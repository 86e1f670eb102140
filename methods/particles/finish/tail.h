// The tail of the shapes: the bad spots that smoothing leaves.
#pragma once

#include "isobench/foundation/monitor.h"
#include "isobench/methods/particles/mesh_edits/editable_mesh.h"
#include "isobench/methods/particles/mesh_edits/shortfall.h"
#include "isobench/methods/particles/mesh_edits/valence_edits.h"

namespace isobench::particles {

/// What the searches try to reach first, with a part of the budget; angles in degrees. Projection to F = c, which
/// follows, changes angles by some hundredths.
ShapeGoal strict_goal(const SizingField& sizing);

/// Local searches at bad spots (bad_spots.h), which become wider, first for the strict goal and then for the usual one.
/// Where edges are long against the features, bad spots crowd, and wide searches at all of them would take minutes. A
/// budget of 1,000 moves a vertex, times `share`, bounds what is spent; other meshes need a small part of it.
///
/// Stage "tail"; counters "finish/searched moves" and "finish/places left".
void improve_tail(const FinishContext& context, EditableMesh& mesh, double share, Monitor& monitor);

}  // namespace isobench::particles
