// Pairs of triangles that meet where they should not, by CGAL's exact predicates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

/// Pairs of triangles that meet elsewhere than in what they share by index: two triangles without a common vertex that
/// touch at all; with one common vertex, if the opposite edge of one meets the other; with a common edge, if they lie
/// in one plane on the same side of it; two triangles of the same three vertices always. Any triangle soup will do.
/// Triangles without area (exactly collinear) bound nothing and are left out; the radius ratio 0 shows them.
///
/// Smaller index first, ascending: the same for any number of threads. Two threads need about 1 s per million
/// triangles.
std::vector<std::array<std::uint32_t, 2>> self_intersections(const TriangleMesh& mesh);

inline std::size_t count_self_intersections(const TriangleMesh& mesh) { return self_intersections(mesh).size(); }

}  // namespace isobench
