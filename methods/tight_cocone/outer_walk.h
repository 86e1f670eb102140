// Which of the cocone's facets are the surface: those that a walk along its outer side comes by.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "methods/tight_cocone/cocone.h"

namespace isobench {

/// For each facet of each cell (4 · cell + facet, from both its sides) whether it is part of the outer manifold. In
/// every edge-connected piece the walk begins outside its lowest vertex and, at each edge, goes on to the next facet
/// on its own side; flat slivers that the candidates enclose stay behind. At an edge with one facet it ends.
std::vector<char> outer_manifold(const DelaunayCells& cells, const std::vector<Eigen::Vector3d>& points,
                                 const std::vector<Cocone::Facet>& facets);

}  // namespace isobench
