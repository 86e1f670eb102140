// Closing points on F = c to a surface: Delaunay-triangulate them, label each cell by the sign of f at its
// circumcentre, and output the facets between unlike cells. Closed, oriented and free of self-intersection by
// construction; equal to the restricted Delaunay triangulation (Amenta, Bern 1999; Boissonnat, Oudot 2005) where each
// dual edge crosses the surface once. What can remain are pinches: edges with four facets, vertices with two fans.
// More points cure them, so the triangulation is kept and points can be added to it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "datasets/isosurface.h"
#include "datasets/monitor.h"
#include "methods/triangle_mesh.h"

namespace isobench {

class LabelledDelaunay {
 public:
  /// A triangle of the surface and its dual edge, from the circumcentre of the cell inside to that of the cell outside
  /// (where that is beyond the convex hull: to a point well outside, across the facet).
  struct Facet {
    Triangle corners;  ///< counter-clockwise seen from outside, indices of points
    Eigen::Vector3d inside;
    Eigen::Vector3d outside;
  };

  /// `points` in the lattice frame, mm, distinct. A circumcentre outside the volume counts as outside the object. Keeps
  /// a reference to the surface. Throws Error if the points span no tetrahedron. Cost: one Delaunay triangulation on
  /// one thread (about 10 µs a point) plus one evaluation of f a cell, on all. The same points in the same order, added
  /// in the same steps, give the same facets.
  LabelledDelaunay(const std::vector<Eigen::Vector3d>& points, const Isosurface& surface, Monitor& monitor);
  ~LabelledDelaunay();
  LabelledDelaunay(LabelledDelaunay&&) noexcept;
  LabelledDelaunay& operator=(LabelledDelaunay&&) = delete;
  LabelledDelaunay(const LabelledDelaunay&) = delete;
  LabelledDelaunay& operator=(const LabelledDelaunay&) = delete;

  /// Time linear in the cells.
  std::vector<Facet> facets() const;
  std::vector<Triangle> triangles() const;

  /// Adds points, whose indices follow those that are there; only the cells that come with them are labelled anew. They
  /// must be distinct from all others. Returns the points whose cells have changed, ascending: facets of which no
  /// corner is among them are as they were.
  std::vector<std::uint32_t> insert(const std::vector<Eigen::Vector3d>& points);

  /// Changes the label of the finite cell that has the least |f|/|∇f| at its circumcentre among those at a point: the
  /// last resort where no point can be added. False where the point has none within half a voxel of the surface.
  bool flip_label_at(std::uint32_t point);

 private:
  struct Triangulation;
  std::unique_ptr<Triangulation> triangulation_;
};

}  // namespace isobench
