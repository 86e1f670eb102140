// Marching cubes on the lattice of an isosurface, with vertices on F = c itself
// (Lorensen, Cline 1987; Meyer, Kirby, Whitaker 2007, section 4: the same spline kernels as every other method there).
#pragma once

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

/// Meshes f = 0 with one vertex on every lattice edge whose ends have different signs, in the lattice frame (mm),
/// triangles counter-clockwise from outside. The signs are those of Isosurface::node_values (f > 0 is inside, so a node
/// exactly on the surface is outside and up to six vertices may coincide in it); the vertex is the root of f along the
/// edge to 1e-14 of its length, any one of them where f crosses three times.
///
/// Triangles come from VTK's 256-case table, which is consistent across faces: the mesh is closed except where the
/// object leaves the lattice. Degenerate triangles are kept. The order of vertices and triangles follows the lattice,
/// so the mesh is the same for any number of threads. Throws Cancelled. Cost: two 3-tap filters a node and four values
/// of f a vertex; memory: one bit a node, two slabs of values a thread.
TriangleMesh marching_cubes(const Isosurface& surface, Monitor& monitor);

}  // namespace isobench
