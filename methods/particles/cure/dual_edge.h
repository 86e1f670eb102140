// Where the dual edge of a facet, between the circumcentres of its two cells, crosses F = c: once, if the triangulation
// is the surface's there.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/methods/closing/labelled_delaunay.h"

namespace isobench::particles {

/// How often f changes its sign on the way from inside to outside, looked at every quarter voxel. Cost: one evaluation
/// of f each.
int crossings(const LabelledDelaunay::Facet& facet, const Isosurface& surface);

/// The points on F = c where it does, from inside to outside.
std::vector<Eigen::Vector3d> crossing_points(const LabelledDelaunay::Facet& facet, const Isosurface& surface);

}  // namespace isobench::particles
