// CGAL's isotropic remeshing, behind an interface that needs none of its headers.
#pragma once

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench::isotropic_remeshing {

/// Splits edges longer than 4/3 of `edge_length` (mm), collapses those shorter than 4/5, flips towards valence 6 and
/// moves vertices to the middle of their neighbours and back to the mesh that was given, `iterations` times (Botsch,
/// Kobbelt 2004, in CGAL's package Polygon Mesh Processing).
/// Corners at one place are joined first, and where that leaves no manifold, doubled. Open borders keep their place.
TriangleMesh remesh(const TriangleMesh& mesh, double edge_length, int iterations);

}  // namespace isobench::isotropic_remeshing
