// Extracts a surface from the facets of a cocone: the facets that a walk along the outer side reaches.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isobench/methods/closing/cocone.h"

namespace isobench {

/// For each facet of each cell, at index 4 · cell + facet, whether it is part of the outer manifold; the same from both
/// sides. In every edge-connected piece, the walk starts outside the piece's lowest vertex and goes at each edge to the
/// next facet on the same side. So it leaves out flat slivers that are enclosed by facets. It stops at edges with a
/// single facet.
///
/// A walk could reach the inner side through a hole. To prevent this, the walk remembers the outer side at each flat
/// vertex and does not enter a facet that contradicts it. The signs of `normals` are arbitrary.
std::vector<char> outer_manifold(const DelaunayCells& cells, const std::vector<Eigen::Vector3d>& points,
                                 const std::vector<Eigen::Vector3d>& normals, const Cocone& cocone);

}  // namespace isobench
