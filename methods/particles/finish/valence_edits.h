// Changes of connectivity that bring valences towards six.
#pragma once

#include <cstddef>

#include "isobench/datasets/isosurface.h"
#include "isobench/methods/particles/finish/editable_mesh.h"
#include "isobench/methods/sizing/sizing_field.h"

namespace isobench::particles {

/// What a mesh must be true to.
struct MeshGround {
  const Isosurface& surface;
  const SizingField& sizing;
};

/// Length of the edge over the mean of h0 at its ends.
double edge_over_h0(const MeshGround& ground, const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Whether the two triangles after a flip are worth having: Q at least `least_q` (or better than the two before),
/// turned by at most 60° from the normals at their corners (or less than the two before), the new edge not above h0.
bool flip_keeps_shape(const MeshGround& ground, const EditableMesh& mesh, EditableMesh::Index e, double least_q);
/// The same for the triangles that a collapse draws to the target.
bool collapse_keeps_shape(const MeshGround& ground, const EditableMesh& mesh, EditableMesh::Index e, double least_q);

/// By how much Σ (valence − 6)² falls when an edge is flipped.
int flip_gain(const EditableMesh& mesh, EditableMesh::Index e);

/// Each goes once through the mesh in the order of its half-edges or vertices and says how many changes it made.
/// Flips where that lets Σ (valence − 6)² fall, until there is none or after a few rounds.
std::size_t flip_for_valence(const MeshGround& ground, EditableMesh& mesh);
/// Flips that raise the smaller Q of two triangles without leaving valences 5 to 7.
std::size_t flip_for_shape(const MeshGround& ground, EditableMesh& mesh);
/// Takes away vertices of valence 3 and 4.
std::size_t collapse_low_valence(const MeshGround& ground, EditableMesh& mesh);
/// Divides vertices of valence 8 and more.
std::size_t split_high_valence(const MeshGround& ground, EditableMesh& mesh);

/// Divides one vertex so that both parts get about as many neighbours, those of few rather than of many at the seam.
/// Returns the new vertex, or none where shapes forbid it.
EditableMesh::Index divide(const MeshGround& ground, EditableMesh& mesh, EditableMesh::Index v);
/// A vertex amid an edge, on F = c; none where that fails.
EditableMesh::Index split_in_the_middle(const MeshGround& ground, EditableMesh& mesh, EditableMesh::Index e);

}  // namespace isobench::particles
