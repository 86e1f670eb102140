// The tail of the finish: places where a triangle, a valence or an edge is still bad are cut out as small meshes, on
// which one tries changes of connectivity, each followed by smoothing, and puts the best result back.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "isobench/methods/particles/finish/editable_mesh.h"
#include "isobench/methods/particles/finish/valence_edits.h"

namespace isobench::particles {

/// What a mesh is to reach everywhere.
struct ShapeGoal {
  double radius_ratio = 0.85;
  double least_angle = 37.5;    ///< degrees
  double largest_angle = 87.5;  ///< degrees
};

/// How much of the goal is missed: 0 where triangles, valences (5 to 7) and edges (up to h0) are all as wanted.
/// Valences of fixed vertices count as well: on a piece they are those of the whole mesh.
double missed(const MeshGround& ground, const EditableMesh& mesh, const ShapeGoal& goal);

/// A piece of a mesh as a mesh of its own: its border is fixed.
struct Submesh {
  EditableMesh mesh;
  std::vector<EditableMesh::Index> vertices;   ///< of the whole mesh, one for each of the piece's
  std::vector<EditableMesh::Index> triangles;  ///< of the whole mesh
  std::vector<EditableMesh::Index> core;       ///< vertices of the piece around which changes are tried
};

/// All triangles with a corner at most `rings` - 1 edges from one of the centres; the core is the centres and their
/// neighbours.
Submesh cut_out(const EditableMesh& mesh, std::span<const EditableMesh::Index> centres, int rings);
void put_back(EditableMesh& mesh, const Submesh& patch);

/// How far to search on a patch.
struct SearchEffort {
  int rings = 3;
  int depth = 1;  ///< changes in a row
  int beam = 1;   ///< states kept after each
};

/// Tries flips, collapses and divisions around the core, with smoothing; true, and the patch changed, where less of the
/// goal is missed then.
bool improve(const MeshGround& ground, Submesh& patch, const ShapeGoal& goal, const SearchEffort& search);

/// Improves all places that miss the goal, those that do not meet in parallel. Returns how many were improved.
/// The result does not depend on the number of threads.
std::size_t improve_bad_spots(const MeshGround& ground, EditableMesh& mesh, const ShapeGoal& goal,
                              const SearchEffort& search);

/// Triangles and vertices that miss the goal.
std::size_t count_bad_spots(const MeshGround& ground, const EditableMesh& mesh, const ShapeGoal& goal);

}  // namespace isobench::particles
