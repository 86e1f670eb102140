// A part of a mesh as a mesh of its own, on which changes can be tried.
#pragma once

#include <span>
#include <vector>

#include "isobench/methods/particles/mesh_edits/editable_mesh.h"

namespace isobench::particles {

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

}  // namespace isobench::particles
