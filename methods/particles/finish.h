// The finish: valences and shapes of a mesh made good, its vertices kept on F = c and its edges below h0.
#pragma once

#include "datasets/isosurface.h"
#include "datasets/monitor.h"
#include "methods/sizing/sizing_field.h"
#include "methods/triangle_mesh.h"

namespace isobench::particles {

TriangleMesh finish(const Isosurface& surface, const SizingField& sizing, const TriangleMesh& mesh, int rounds,
                    Monitor& monitor);

}  // namespace isobench::particles
