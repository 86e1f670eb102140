// Pairs of triangles that intersect, by CGAL's exact predicates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

/// Pairs of triangles that meet outside their common vertices and edges. Two triangles are such a pair
/// - without a common vertex: if they touch;
/// - with one common vertex: if the edge opposite to it in one triangle meets the other triangle;
/// - with a common edge: if they lie in one plane, on the same side of the edge;
/// - with three common vertices: always.
/// Vertices are common if they have the same index. Any triangle soup is allowed. Triangles without area (exactly
/// collinear corners) are ignored; they show as triangles with radius ratio 0.
///
/// In each pair the smaller index comes first; pairs ascend. The same for any number of threads. Two threads take about
/// 1 s per million triangles.
std::vector<std::array<std::uint32_t, 2>> self_intersections(const TriangleMesh& mesh);

/// The same, but only pairs with a triangle that is marked: `marked` has one entry for each triangle. A tree
/// over the marked triangles finds those near them; the rest costs one look each.
std::vector<std::array<std::uint32_t, 2>> self_intersections(const TriangleMesh& mesh,
                                                             const std::vector<std::uint8_t>& marked);

inline std::size_t count_self_intersections(const TriangleMesh& mesh) { return self_intersections(mesh).size(); }

}  // namespace isobench
