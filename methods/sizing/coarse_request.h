// What a user should know whose sizing is coarser than the surface allows.
#pragma once

#include <string>

#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/methods/sizing/sizing_field.h"

namespace isobench {

/// One sentence if the edges that are asked for are longer than the object, or if the mesh has far more vertices than
/// are asked for (twice as many), which its topology needs; else "". Cost: linear in the number of vertices.
std::string coarse_request(const SizingRequest& request, const TriangleMesh& mesh);

}  // namespace isobench
