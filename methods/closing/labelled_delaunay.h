// A closed surface through points on F = c: the points are Delaunay-triangulated, each cell is labelled inside or
// outside by the sign of f at its circumcentre, and the facets between cells with different labels are the surface. It
// is closed, oriented and free of self-intersections by construction. Where each dual edge crosses F = c once, it
// equals the restricted Delaunay triangulation (Amenta, Bern 1999; Boissonnat, Oudot 2005). It can have pinches: edges
// with four facets and vertices with two fans. More points remove them, so points of a triangulation can be exchanged.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "isobench/datasets/isosurface.h"
#include "isobench/foundation/monitor.h"
#include "isobench/methods/mesh/triangle_mesh.h"

namespace isobench {

class LabelledDelaunay {
 public:
  /// A triangle of the surface and its dual edge, from the circumcentre of the inside cell to the circumcentre of the
  /// outside cell. At the convex hull, the dual edge ends at a point far outside the facet.
  struct Facet {
    Triangle corners;  ///< indices of points, counter-clockwise seen from outside, least first
    Eigen::Vector3d inside;
    Eigen::Vector3d outside;
  };

  /// `points` are in the lattice frame, mm, and distinct (of two that are not, triangles() has one; the functions below
  /// that take points may not be called). A circumcentre outside the volume counts as outside the object.
  /// Keeps a reference to the surface. Throws Error if the points span no tetrahedron. The same points in the same
  /// order, added in the same steps, give the same facets. Cost: one Delaunay triangulation on one thread, about 10 µs
  /// a point, and one evaluation of f a cell on all threads.
  LabelledDelaunay(const std::vector<Eigen::Vector3d>& points, const Isosurface& surface, Monitor& monitor);
  ~LabelledDelaunay();
  LabelledDelaunay(LabelledDelaunay&&) noexcept;
  LabelledDelaunay& operator=(LabelledDelaunay&&) = delete;
  LabelledDelaunay(const LabelledDelaunay&) = delete;
  LabelledDelaunay& operator=(const LabelledDelaunay&) = delete;

  /// All facets of the surface, sorted by corners, as are the lists below. Time is linear in the number of cells.
  std::vector<Facet> facets() const;
  /// The facets with a corner among `points`, which are ascending. Time is linear in the number of these points, plus
  /// the time to clear one byte for every point of the triangulation.
  std::vector<Facet> facets_at(const std::vector<std::uint32_t>& points) const;
  std::vector<Triangle> triangles() const;

  /// Removes the points with the indices `removed`, ascending, and adds `points`, which are distinct from all that
  /// stay. The points that stay keep their order; the new points come after them. Only new cells, and some others at
  /// the same corners, are labelled again; a label changed by flip_label_at may be lost there.
  ///
  /// Returns the new indices, ascending, of the points whose cells have changed. A facet without such a corner has not
  /// changed. Throws Error if the points no longer span a tetrahedron, or if a new point coincides with one that stays;
  /// the triangulation must not be used after that. Cost: about 50 µs per removed point and 20 µs per added point, on
  /// one thread.
  std::vector<std::uint32_t> replace(const std::vector<std::uint32_t>& removed,
                                     const std::vector<Eigen::Vector3d>& points);
  /// Adds points.
  std::vector<std::uint32_t> insert(const std::vector<Eigen::Vector3d>& points) { return replace({}, points); }

  /// The point nearest to x. The search starts at point `near`.
  std::uint32_t nearest(const Eigen::Vector3d& x, std::uint32_t near) const;

  /// The points of a cell, ascending.
  using Corners = std::array<std::uint32_t, 4>;

  /// Changes the label of one finite cell at a point, and returns the cell's corners. The cells are ranked by how near
  /// their circumcentres are to the surface, by |f|/|∇f|; 0 is the nearest. Doing it again changes the label back. This
  /// is the last resort where no point can be added. Returns nothing, and changes nothing, if `rank` or fewer cells
  /// have their circumcentres within half a voxel of the surface.
  std::optional<Corners> flip_label_at(std::uint32_t point, std::size_t rank = 0);

 private:
  struct Triangulation;
  std::unique_ptr<Triangulation> triangulation_;
};

}  // namespace isobench
