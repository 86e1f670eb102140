// Changes of connectivity that bring valences closer to six.
#pragma once

#include <cstddef>

#include "isobench/datasets/isosurface.h"
#include "isobench/methods/particles/mesh_edits/asked_areas.h"
#include "isobench/methods/particles/mesh_edits/editable_mesh.h"
#include "isobench/methods/particles/mesh_edits/shape_energy.h"
#include "isobench/methods/sizing/sizing_field.h"

namespace isobench::particles {

/// Cosine of the largest angle allowed between a triangle and the normals of F at its corners, unless the angle was
/// larger before.
constexpr double least_cosine = 0.5;

/// The energies that smoothing minimises: in the rounds and in local searches, and in the last sweeps over the mesh.
struct FinishEnergies {
  ShapeEnergy rounds;
  ShapeEnergy last;
};
/// Tuned in trials on the sphere, the torus and the real volumes. A gradation does not allow triangles that are both
/// equilateral and of the areas asked for, so areas weigh less there. `weight` multiplies all weights of areas.
FinishEnergies finish_energies(const SizingField& sizing, double weight = 1.0);

/// The surface on which the vertices of a mesh are, the sizing that bounds its edges, and what smoothing aims at.
struct FinishContext {
  const Isosurface& surface;
  const SizingField& sizing;
  AskedAreas areas;
  FinishEnergies energies;
  double least_cosine_of_moves = least_cosine;  ///< the same as least_cosine for moves of vertices
};

/// The length of an edge divided by the mean of h0 at its ends.
double edge_over_h0(const FinishContext& context, const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Whether the two triangles after a flip are acceptable: their Q is at least `least_q`, or better than before; they
/// are within 60° of the normals at their corners, or closer than before; and, with an adaptive sizing, the new edge is
/// not above h0, or not longer than the old one relative to h0.
bool flip_keeps_shape(const FinishContext& context, const EditableMesh& mesh, EditableMesh::Index e, double least_q);
/// Whether the triangles after a collapse are acceptable: Q at least `least_q`, within 60° of the normals at their
/// corners, and, with an adaptive sizing, no edge above h0.
bool collapse_keeps_shape(const FinishContext& context, const EditableMesh& mesh, EditableMesh::Index e,
                          double least_q);

/// Of the half-edges at a movable vertex whose collapse removes it and is acceptable, the one after which the valences
/// are best; `none` if there is none.
EditableMesh::Index best_collapse(const FinishContext& context, const EditableMesh& mesh, EditableMesh::Index v,
                                  double least_q);

/// The decrease of Σ (valence − 6)² when an edge is flipped.
int flip_gain(const EditableMesh& mesh, EditableMesh::Index e);

// The next four functions visit half-edges or vertices in order and return the number of changes.

/// Flips edges where Σ (valence − 6)² falls, in up to four rounds.
std::size_t flip_for_valence(const FinishContext& context, EditableMesh& mesh);
/// Flips edges where the smaller Q of the two triangles rises and valences stay within 5 to 7.
std::size_t flip_for_shape(const FinishContext& context, EditableMesh& mesh);
/// Removes vertices of valence 3 and 4 by collapses.
std::size_t collapse_low_valence(const FinishContext& context, EditableMesh& mesh);
/// Splits vertices of valence 8 or more.
std::size_t split_high_valence(const FinishContext& context, EditableMesh& mesh);

/// Splits a vertex into two with about equally many neighbours. The two neighbours that gain an edge are those with low
/// valences. Returns the new vertex, or `none` if the vertex has fewer than six neighbours or the shapes do not allow
/// it.
EditableMesh::Index divide_vertex(const FinishContext& context, EditableMesh& mesh, EditableMesh::Index v);
/// Splits an edge by a vertex near its middle on F = c. Returns the new vertex, or `none` if there is no such point.
EditableMesh::Index split_edge_at_middle(const FinishContext& context, EditableMesh& mesh, EditableMesh::Index e);

}  // namespace isobench::particles
