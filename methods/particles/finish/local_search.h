// The tail of the finish: a local search at bad spots, where a triangle, a valence or an edge misses its goal. It
// extracts a small submesh around each spot, tries changes of connectivity followed by smoothing, and puts the best
// result back.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "isobench/methods/particles/finish/editable_mesh.h"
#include "isobench/methods/particles/finish/valence_edits.h"

namespace isobench::particles {

/// The bounds that all triangles should meet.
struct ShapeGoal {
  double radius_ratio = 0.85;   ///< least 2 r/R (shape_energy.h)
  double least_angle = 37.5;    ///< degrees
  double largest_angle = 87.5;  ///< degrees
};

/// How far a mesh is from the goal: 0 if all triangles, valences (5 to 7) and edges (up to h0) meet it. Valences of
/// fixed vertices count as well; in a submesh they are the valences in the whole mesh.
double shortfall(const FinishContext& context, const EditableMesh& mesh, const ShapeGoal& goal);

/// A part of a mesh as a mesh of its own, with a fixed border.
struct Submesh {
  EditableMesh mesh;
  std::vector<EditableMesh::Index> vertices;   ///< for each vertex of the submesh, its index in the whole mesh
  std::vector<EditableMesh::Index> triangles;  ///< indices of the extracted triangles in the whole mesh
  std::vector<EditableMesh::Index> core;       ///< vertices of the submesh around which changes are tried
};

/// Extracts all triangles with a corner at most `rings` − 1 edges from one of the centres. The core consists of the
/// centres and their neighbours.
Submesh extract_submesh(const EditableMesh& mesh, std::span<const EditableMesh::Index> centres, int rings);
/// Replaces the extracted triangles by the triangles of the submesh.
void put_back_submesh(EditableMesh& mesh, const Submesh& submesh);

/// The extent of a search.
struct SearchEffort {
  int rings = 3;  ///< size of the submesh (extract_submesh)
  int depth = 1;  ///< number of changes in a row
  int beam = 1;   ///< number of states kept after each change
};

/// Tries flips, collapses and splits around the core, each with smoothing. If the best result reduces the shortfall by
/// at least 1 %, the submesh becomes that result, and the function returns true.
bool improve(const FinishContext& context, Submesh& submesh, const ShapeGoal& goal, const SearchEffort& search);

/// Searches at all bad spots whose submeshes do not overlap, in parallel. Returns how many were improved. The result
/// does not depend on the number of threads.
std::size_t improve_bad_spots(const FinishContext& context, EditableMesh& mesh, const ShapeGoal& goal,
                              const SearchEffort& search);

/// The number of bad spots: vertices whose valence misses the goal, and triangles that miss it or have an edge above
/// h0. A spot without a movable vertex does not count.
std::size_t count_bad_spots(const FinishContext& context, const EditableMesh& mesh, const ShapeGoal& goal);

}  // namespace isobench::particles
