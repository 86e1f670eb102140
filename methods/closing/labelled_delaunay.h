// Closing points on F = c to a surface: Delaunay-triangulate them, label each cell by the sign of f at its
// circumcentre, and output the facets between unlike cells. Closed, oriented and free of self-intersection by
// construction; equal to the restricted Delaunay triangulation (Amenta, Bern 1999; Boissonnat, Oudot 2005) where each
// dual edge crosses the surface once. What can remain are pinches: edges with four facets, vertices with two fans.
// More points cure them, so the triangulation is kept and points of it can be exchanged.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

class LabelledDelaunay {
 public:
  /// A triangle of the surface and its dual edge, from the circumcentre of the cell inside to that of the cell outside
  /// (where that is beyond the convex hull: to a point well outside, across the facet).
  struct Facet {
    Triangle corners;  ///< counter-clockwise seen from outside, indices of points, the least first
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

  /// By ascending corners, as all below. Time linear in the cells.
  std::vector<Facet> facets() const;
  /// Those with a corner among `points`, which are ascending. Time linear in these points, but for a byte of all.
  std::vector<Facet> facets_at(const std::vector<std::uint32_t>& points) const;
  std::vector<Triangle> triangles() const;

  /// Takes away the points `gone`, ascending, and adds `points`, distinct from all that stay: those that stay close
  /// ranks, and the new ones follow them. Only cells that come by this, and others at their corners, are labelled
  /// (anew, if by flip_label_at). Returns the points, as now numbered, whose cells have changed, ascending: facets of
  /// which no corner is among them are as they were. Throws Error if the points no longer span a tetrahedron,
  /// and where one comes onto one that stays; the triangulation is of no use then. Cost: some 50 µs a point that goes,
  /// 20 one that comes, on one thread.
  std::vector<std::uint32_t> replace(const std::vector<std::uint32_t>& gone,
                                     const std::vector<Eigen::Vector3d>& points);
  /// Adds points only.
  std::vector<std::uint32_t> insert(const std::vector<Eigen::Vector3d>& points) { return replace({}, points); }

  /// The point nearest to x, sought from one that is near.
  std::uint32_t nearest(const Eigen::Vector3d& x, std::uint32_t near) const;

  /// Changes the label of the finite cell that has the least |f|/|∇f| at its circumcentre among those at a point: the
  /// last resort where no point can be added. False where the point has none within half a voxel of the surface.
  bool flip_label_at(std::uint32_t point);

 private:
  struct Triangulation;
  std::unique_ptr<Triangulation> triangulation_;
};

}  // namespace isobench
