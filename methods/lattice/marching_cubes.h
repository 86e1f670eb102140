// Marching cubes on the lattice of an isosurface, with vertices on F = c itself (Lorensen, Cline 1987). As in Meyer,
// Kirby, Whitaker 2007, section 4, it uses the same spline kernels as the other methods.
#pragma once

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

/// Meshes f = 0 in the lattice frame (mm), with triangles counter-clockwise from outside and one vertex on every
/// lattice edge whose ends have different signs. Signs come from Isosurface::node_values: f > 0 is inside. A node
/// exactly on the surface is outside, and up to six vertices may coincide with it. A vertex is the root of f along its
/// edge, within 1e-14 of the edge's length; if f has three roots there, it is any one of them.
///
/// Triangles come from VTK's table of 256 cases, which is consistent across faces. So the mesh is closed except where
/// the object leaves the lattice. Degenerate triangles are kept. The order of vertices and triangles follows the
/// lattice, so the mesh does not depend on the number of threads. Throws Cancelled. Cost: two 3-tap filters per node
/// and four evaluations of f per vertex. Memory: one bit per node, and vertex numbers for two slabs per thread.
TriangleMesh marching_cubes(const Isosurface& surface, Monitor& monitor);

}  // namespace isobench
