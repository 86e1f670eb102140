// Smoothing: moves vertices on F = c so that the triangles around them get better shapes.
#pragma once

#include <span>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/methods/particles/mesh_edits/editable_mesh.h"
#include "isobench/methods/particles/mesh_edits/shape_energy.h"
#include "isobench/methods/particles/mesh_edits/valence_edits.h"

namespace isobench::particles {

/// The neighbours of a movable vertex; `areas` are those asked at the vertices of the mesh. Returns false, with an
/// unusable ring, if there are more than Ring::most.
bool gather_ring(const EditableMesh& mesh, const std::vector<double>& areas, EditableMesh::Index v, Ring& ring);

/// Moves v by one Newton step on its shape energy in its tangent plane and one Newton step back to F = c. The step is
/// shortened until the energy falls. Returns the length of the move, divided by the mean distance to the neighbours.
double improve_vertex(const FinishContext& context, EditableMesh& mesh, const std::vector<double>& areas,
                      EditableMesh::Index v, const ShapeEnergy& energy);

/// The movable vertices in classes such that no two vertices of a class are neighbours.
std::vector<std::vector<EditableMesh::Index>> colour(const EditableMesh& mesh);

/// `sweeps` sweeps over all movable vertices, one class after another, each class in parallel. Skips a vertex if
/// neither it nor a neighbour moved in its last turn. The areas asked are those at the start. The result does not
/// depend on the number of threads.
void smooth(const FinishContext& context, EditableMesh& mesh, const ShapeEnergy& energy, int sweeps);

/// The same for some vertices, in the order given and on one thread, and no longer than they move. Returns how often it
/// tried to move one.
std::size_t smooth(const FinishContext& context, EditableMesh& mesh, const ShapeEnergy& energy, int sweeps,
                   std::span<const EditableMesh::Index> vertices);

/// Projects all movable vertices to F = c, within 1e-6 voxel.
void project_all(const Isosurface& surface, EditableMesh& mesh);
/// The same for some vertices.
void project(const Isosurface& surface, EditableMesh& mesh, std::span<const EditableMesh::Index> vertices);

}  // namespace isobench::particles
