// Where the dual edge of a facet, which joins the circumcentres of its two cells, crosses F = c. It crosses once if the
// triangulation agrees with the surface there.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/methods/closing/labelled_delaunay.h"

namespace isobench::particles {

/// The number of sign changes of f along the dual edge from inside to outside, sampled at least every quarter voxel.
/// Cost: one evaluation of f a sample.
int count_crossings(const LabelledDelaunay::Facet& facet, const Isosurface& surface);

/// The points on F = c at these sign changes, from inside to outside.
std::vector<Eigen::Vector3d> crossing_points(const LabelledDelaunay::Facet& facet, const Isosurface& surface);

}  // namespace isobench::particles
