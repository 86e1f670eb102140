// Pairs of triangles that meet where they should not, by CGAL's exact predicates.
#pragma once

#include <cstddef>

#include "methods/triangle_mesh.h"

namespace isobench {

/// Counts pairs of triangles that meet elsewhere than in what they share by index: two triangles without a common
/// vertex that touch at all; with one common vertex, if the opposite edge of one meets the other; with a common edge,
/// if they lie in one plane on the same side of it; two triangles of the same three vertices always. Any triangle soup
/// will do. Triangles without area (exactly collinear) bound nothing and are left out; the radius ratio 0 shows them.
/// Two threads need about 2 s per million triangles; the count does not depend on the number of threads.
std::size_t count_self_intersections(const TriangleMesh& mesh);

}  // namespace isobench
