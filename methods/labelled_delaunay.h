// Closing points on F = c to a surface: Delaunay-triangulate them, label each cell by the sign of f at its
// circumcentre, and output the facets between unlike cells. Closed, oriented and free of self-intersection by
// construction; equal to the restricted Delaunay triangulation (Amenta, Bern 1999; Boissonnat, Oudot 2005) where each
// dual edge crosses the surface once. What can remain are pinches: edges with four facets, vertices with two fans.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "datasets/isosurface.h"
#include "datasets/monitor.h"
#include "methods/triangle_mesh.h"

namespace isobench {

struct LabelledDelaunay {
  std::vector<Triangle> triangles;  ///< counter-clockwise seen from outside, indices into the points
  std::size_t cells = 0;            ///< finite cells of the Delaunay triangulation
};

/// `points` in the lattice frame, mm, distinct. A circumcentre outside the volume counts as outside the object.
/// Throws Error if the points span no tetrahedron. Cost: one Delaunay triangulation on one thread (about 10 µs a point)
/// plus one evaluation of f a cell, on all. The same points in the same order give the same triangles.
LabelledDelaunay labelled_delaunay(const std::vector<Eigen::Vector3d>& points, const Isosurface& surface,
                                   Monitor& monitor);

}  // namespace isobench
