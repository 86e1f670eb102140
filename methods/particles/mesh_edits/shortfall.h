// How far a mesh is from the shapes, valences and edge lengths that the finish aims at.
#pragma once

#include "isobench/methods/particles/mesh_edits/editable_mesh.h"
#include "isobench/methods/particles/mesh_edits/valence_edits.h"

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

/// The shares of one triangle, of one vertex, and of the edge of a half-edge.
double triangle_shortfall(const EditableMesh& mesh, const Triangle& t, const ShapeGoal& goal);
double valence_shortfall(const EditableMesh& mesh, EditableMesh::Index v);
double edge_shortfall(const FinishContext& context, const EditableMesh& mesh, EditableMesh::Index e);
/// The same for an edge whose length over h0 is known.
double edge_shortfall(double over_h0);

/// True for one half-edge of each edge.
bool is_first_of_edge(const EditableMesh& mesh, EditableMesh::Index e);

}  // namespace isobench::particles
