// The Voronoi cells of points on a surface, restricted to the triangles that their Delaunay triangulation has there:
// each triangle is shared out among its corners by the perpendicular bisectors of its edges. Where a triangle is obtuse
// its circumcentre lies beyond an edge, and the neighbour there takes as much less as this one takes more.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench::cvt {

/// The density that makes edges of length h: ∫ρ|x − p|² is least where cells are as wide as ρ^(−1/4) (in two
/// dimensions; Gersho 1979), so ρ = 1/h⁴.
double density(double h);

struct Cells {
  std::vector<double> mass;                ///< ∫ρ of each point's cell
  std::vector<Eigen::Vector3d> centroids;  ///< ∫ρx/∫ρ; the point itself where it has no cell
  double energy = 0.0;                     ///< Σ ∫ρ|x − p|²
  /// The least that so many points on so much surface could have: 5/(18√3) (∫√ρ)²/n, regular hexagons all over
  /// (L. Fejes Tóth; Gersho 1979).
  double hexagonal = 0.0;
};

/// `h` > 0 of each point, mm; linear in between. Multi-threaded; sums have a fixed order.
Cells voronoi_cells(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& h,
                    const std::vector<Triangle>& triangles);

}  // namespace isobench::cvt
