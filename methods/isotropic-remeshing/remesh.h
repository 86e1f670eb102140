// CGAL's isotropic remeshing, behind an interface without CGAL's headers.
#pragma once

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench::isotropic_remeshing {

/// Repeats `iterations` times: split edges longer than 4/3 of `edge_length` (mm), collapse edges shorter than 4/5 of
/// it, flip edges towards valence 6, move vertices to the centroid of their neighbours, project them to the input mesh
/// (Botsch, Kobbelt 2004; CGAL's package Polygon Mesh Processing).
/// Vertices at the same position are merged first; where the result is not manifold, vertices are duplicated. Vertices
/// on open borders stay on them.
TriangleMesh remesh(const TriangleMesh& mesh, double edge_length, int iterations);

}  // namespace isobench::isotropic_remeshing
