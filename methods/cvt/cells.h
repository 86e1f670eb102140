// The Voronoi cells of points on a surface, restricted to a Delaunay mesh of the points: the perpendicular bisectors of
// a triangle's edges divide the triangle among its corners. The circumcentre of an obtuse triangle is beyond its
// longest edge; parts beyond that edge count as negative, so that the shares still add up to the triangle's area.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench::cvt {

/// The density ρ = 1/h⁴ that leads to edges of length h: in two dimensions, Σ ∫ρ|x − p|² is least when the width of
/// cells is proportional to ρ^(−1/4) (Gersho 1979).
double density(double h);

struct Cells {
  std::vector<double> mass;                ///< ∫ρ over the cell of each point
  std::vector<Eigen::Vector3d> centroids;  ///< ∫ρx/∫ρ over the cell; the point itself if it has no cell
  double energy = 0.0;                     ///< Σ ∫ρ|x − p|²
  /// The least possible energy of n cells, all regular hexagons: 5/(18√3) (∫√ρ)²/n (L. Fejes Tóth; Gersho 1979).
  double hexagonal = 0.0;
};

/// `h` > 0 is the size at each point, mm; it is linear in between. Multi-threaded, with a fixed order of summation.
Cells voronoi_cells(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& h,
                    const std::vector<Triangle>& triangles);

}  // namespace isobench::cvt
