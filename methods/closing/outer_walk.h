// Which of the cocone's facets are the surface: those that a walk along its outer side comes by.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isobench/methods/closing/cocone.h"

namespace isobench {

/// For each facet of each cell (4 · cell + facet, from both its sides) whether it is part of the outer manifold. In
/// every edge-connected piece the walk begins outside its lowest vertex and, at each edge, goes on to the next facet
/// on its own side; flat slivers that the candidates enclose stay behind. At an edge with one facet it ends. Through
/// holes it would come to the inner side: it does not go on to a facet whose outside is where a flat vertex of it, seen
/// before, has its inside. `normals` need not agree in direction.
std::vector<char> outer_manifold(const DelaunayCells& cells, const std::vector<Eigen::Vector3d>& points,
                                 const std::vector<Eigen::Vector3d>& normals, const Cocone& cocone);

}  // namespace isobench
