// Moving vertices of a mesh over F = c to where the triangles around them have better shapes.
#pragma once

#include <span>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/methods/particles/finish/editable_mesh.h"
#include "isobench/methods/particles/finish/shape_energy.h"
#include "isobench/methods/particles/finish/valence_edits.h"

namespace isobench::particles {

/// Triangles may be turned this far from the normals of F at their corners, unless they were turned farther before.
constexpr double least_cosine = 0.5;
/// Moves hold to this where edges are of one length: nothing but the vertices' places then keeps a mesh close to a
/// surface that bends within an edge, and good shapes would have them slide off its tips. (Where lengths follow the
/// feature size, it would be in the way at the sharpest places, which the sizing holds already.)
constexpr double least_cosine_uniform = 0.8;

/// The neighbours of a movable vertex. False, and nothing usable, where they are more than a ring takes.
bool gather_ring(const EditableMesh& mesh, EditableMesh::Index v, Ring& ring);

/// One Newton step of v on the energy of its triangles, in its tangent plane, and one back to F = c, shortened until
/// the energy falls. Returns how far v moved against its mean distance from its neighbours.
double improve_vertex(const MeshGround& ground, EditableMesh& mesh, EditableMesh::Index v, ShapeEnergy energy);

/// Vertices in classes of which no two are neighbours.
std::vector<std::vector<EditableMesh::Index>> colour(const EditableMesh& mesh);

/// `sweeps` sweeps over all movable vertices, one class after another, each in parallel; vertices that rest among
/// neighbours that rest are passed over. The result does not depend on the number of threads.
void smooth(const MeshGround& ground, EditableMesh& mesh, ShapeEnergy energy, int sweeps);

/// The same over some vertices in the order given, on one thread.
void smooth(const MeshGround& ground, EditableMesh& mesh, ShapeEnergy energy, int sweeps,
            std::span<const EditableMesh::Index> vertices);

/// All movable vertices to F = c within 1e-6 voxel.
void project_all(const Isosurface& surface, EditableMesh& mesh);

}  // namespace isobench::particles
